#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// A YAML document as JSON, by the core schema of YAML 1.2: plain scalars become null, booleans
/// (true, false), numbers or text. Variables of the environment are expanded first; an expanded
/// scalar becomes text where the schema takes text, even if it looks like a number. Members have
/// the names that they have now, whatever they are called in the text.
struct JsonReading {
  nlohmann::json document;
  Places places;
  std::vector<Fault> renamed;  ///< warnings of former names
};

/// Reads a document that is to have that schema, which is not checked. Faults are added: those of
/// read_yaml, infinities and NaN, variables that are not set, a former name beside its new one.
JsonReading read_json(std::string_view yaml, const std::string& file, const nlohmann::json& schema,
                      const Environment& environment, std::vector<Fault>& faults);

/// A document without any such fault, and as its schema has it. Throws Faults.
JsonReading read_valid_json(std::string_view yaml, const std::string& file,
                            const nlohmann::json& schema,
                            const Environment& environment = process_environment());

/// Keys of the map at `path` in the order in which they were written. (JSON sorts them.)
std::vector<std::string> written_order(const nlohmann::json& map, const std::string& path,
                                       const Places& places);

}  // namespace mien::pipeline
