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
/// (true, false), decimal numbers (integers if whole) or text; hexadecimal and octal numbers remain
/// text. Environment variables are expanded first; an expanded scalar becomes text where the schema
/// accepts text, even if it looks like a number. Members that are written with a former name are
/// stored with the present one.
struct JsonReading {
  nlohmann::json document;
  Places places;
  std::vector<Fault> renamed;  ///< warnings about former names
};

/// Reads a document. `schema` is used for expanding variables and for former names; the document is
/// not checked against it. Adds faults to `faults`: those of read_yaml, infinities and NaN,
/// variables that are unset or malformed, members given under both a former and their present name,
/// and paths of values that exceed 256 MiB in total.
JsonReading read_json(std::string_view yaml, const std::string& file, const nlohmann::json& schema,
                      const Environment& environment, std::vector<Fault>& faults);

/// Reads a document and checks it against its schema. Throws Faults.
JsonReading read_valid_json(std::string_view yaml, const std::string& file,
                            const nlohmann::json& schema,
                            const Environment& environment = process_environment());

/// Keys of the map at `path` in the order of the document (JSON sorts them).
std::vector<std::string> written_order(const nlohmann::json& map, const std::string& path,
                                       const Places& places);

}  // namespace mien::pipeline
