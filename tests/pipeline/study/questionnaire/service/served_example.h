#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/service/served_study.h"

namespace mien::pipeline {

/// A small study with trials of every kind: practice, ratings on points, a slider and in words, an
/// attention check, an emotion, a pair, and then `more` ratings. `folder` gets its media.
ServedStudy example_study(const std::filesystem::path& folder, int participants, int more = 0);

/// What a well-behaved page gives of a record.
nlohmann::json good_record(const ServedStudy& study, int plan, const std::string& name,
                           const std::string& browser = "a1b2");

}  // namespace mien::pipeline
