#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace mien::test {

/// All properties of a schema by their paths, elements of arrays as "[]" and keys that a map's
/// author chooses left out: "stimuli[].output.fps". Of alternatives, all are there. Former names
/// are left out.
std::map<std::string, nlohmann::json> properties_of(const nlohmann::json& schema);

}  // namespace mien::test
