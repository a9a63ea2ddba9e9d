#include "pipeline/base/documents/psych_ds.h"

#include <cctype>

namespace mien::pipeline {

namespace {

std::string alphanumeric(const std::string& text) {
  std::string kept;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) kept += c;
  return kept.empty() ? "study" : kept;
}

}  // namespace

std::string psych_ds_path(const std::string& study, std::string_view what) {
  return "data/study-" + alphanumeric(study) + "_description-" + std::string(what) + "_data.csv";
}

nlohmann::ordered_json psych_ds_variable(std::string_view name, std::string_view meaning,
                                         std::string_view unit) {
  nlohmann::ordered_json variable = {
      {"@type", "PropertyValue"}, {"name", name}, {"description", meaning}};
  if (!unit.empty()) variable["unitText"] = unit;
  return variable;
}

nlohmann::ordered_json psych_ds_description(std::string_view name, std::string_view description,
                                            nlohmann::ordered_json variables) {
  return {{"@context", "https://schema.org/"},
          {"@type", "Dataset"},
          {"name", name},
          {"description", description},
          {"schemaVersion", "Psych-DS 0.4.0"},
          {"variableMeasured", std::move(variables)}};
}

}  // namespace mien::pipeline
