#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/yaml_json.h"

namespace mien::pipeline {

// Options of a command that say what a document says: a key and its YAML text each.

/// The document that they make, held against the schema. Throws Faults as `as_options`.
JsonReading read_options(const std::string& yaml, const nlohmann::json& schema,
                         const Environment& environment);

/// Faults as somebody reads them who has written options, and no file: "--size: …".
Faults as_options(std::vector<Fault> faults);

}  // namespace mien::pipeline
