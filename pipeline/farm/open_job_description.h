#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/farm/slurm/batch_script.h"
#include "pipeline/farm/stages.h"

namespace mien::pipeline {

/// A job template of the Open Job Description specification, version 2023-09
/// (https://github.com/OpenJobDescription/openjd-specifications): a step a stage, over the numbers
/// of its elements, and one for what is left. Program, manifest and folder are parameters of the
/// job, which may be given otherwise when it is submitted. Throws Error for what the specification
/// cannot say.
nlohmann::ordered_json open_job_template(const std::vector<Stage>& stages, const StudyCall& call,
                                         const JobRequest& request);

/// The template as a file of that ending: .json, or .yaml and .yml, since JSON is YAML. Throws
/// Error for another one.
std::string open_job_text(const nlohmann::ordered_json& job, const std::filesystem::path& file);

}  // namespace mien::pipeline
