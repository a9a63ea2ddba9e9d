#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_tree.h"

namespace mien::pipeline {

/// A YAML document as JSON, by the core schema of YAML 1.2: plain scalars become null, booleans
/// (true, false), numbers or text. Variables of the environment are expanded first; an expanded
/// scalar becomes text where the schema takes text, even if it looks like a number.
struct JsonReading {
  nlohmann::json document;
  Places places;
};

/// Faults: infinities and NaN, variables that are not set.
JsonReading to_json(const YamlNode& root, SchemaNode schema, const Environment& environment,
                    std::vector<Fault>& faults);

/// Keys of the map at `path` in the order in which they were written. (JSON sorts them.)
std::vector<std::string> written_order(const nlohmann::json& map, const std::string& path,
                                       const Places& places);

}  // namespace mien::pipeline
