#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/farm/slurm/batch_script.h"
#include "pipeline/farm/stages.h"

namespace mien::pipeline {

/// A job template of the Open Job Description specification, version 2023-09
/// (https://github.com/OpenJobDescription/openjd-specifications): one step per stage, with the
/// element number as its task parameter, and a final step for the remaining tasks. Program,
/// manifest and the folder of all studies are job parameters, which can be overridden on
/// submission. Throws Error if the specification cannot express the job.
nlohmann::ordered_json open_job_template(const std::vector<Stage>& stages, const StudyCall& call,
                                         const JobRequest& request);

/// The template as text for a file named .json, .yaml or .yml (JSON is YAML). Throws Error for any
/// other extension.
std::string open_job_text(const nlohmann::ordered_json& job, const std::filesystem::path& file);

}  // namespace mien::pipeline
