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

/// The document `yaml`, formed by such options, checked against the schema. Throws Faults worded by
/// `as_option_faults`.
JsonReading read_options(const std::string& yaml, const nlohmann::json& schema,
                         const Environment& environment);

/// Faults worded for command-line options instead of a document: "--size: …". Faults of other files
/// remain unchanged.
Faults as_option_faults(std::vector<Fault> faults);

}  // namespace mien::pipeline
