#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// What a lab must know to run an exported questionnaire.
std::string lab_text(const Manifest& manifest, const std::vector<SessionPlan>& plans);

/// The codebook of the answers: a Psych-DS dataset_description.json, a Dataset of schema.org in
/// JSON-LD, with every column of answers and participants.
nlohmann::ordered_json dataset_description(const Manifest& manifest);

/// What stands in the folder that answers are put into.
std::string data_folder_text();

}  // namespace mien::pipeline
