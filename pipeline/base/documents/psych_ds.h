#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

// Parts of datasets by the rules of Psych-DS 0.4.0 (psych-ds.github.io).

/// "data/study-emotionstudy_description-answers_data.csv": keywords and values consist of letters
/// and digits.
std::string psych_ds_path(const std::string& study, std::string_view what);

/// A column as a PropertyValue of schema.org.
nlohmann::ordered_json psych_ds_variable(std::string_view name, std::string_view meaning,
                                         std::string_view unit = "");

/// The content of dataset_description.json (JSON-LD), without keywords. `variables`: a list of
/// psych_ds_variable.
nlohmann::ordered_json psych_ds_description(std::string_view name, std::string_view description,
                                            nlohmann::ordered_json variables);

}  // namespace mien::pipeline
