#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/yaml_json.h"

namespace mien::pipeline {

// Command-line options that correspond to a document's options. Together, as lines "key: value",
// they form a YAML document.

/// The document formed by such options, `yaml`, checked against the schema. Throws Faults, worded
/// as by `as_option_faults`.
JsonReading read_options(const std::string& yaml, const nlohmann::json& schema,
                         const Environment& environment);

/// Faults worded for command-line options instead of a file: "--size: …".
Faults as_option_faults(std::vector<Fault> faults);

}  // namespace mien::pipeline
