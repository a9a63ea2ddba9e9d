#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace mien::pipeline {

/// A map as YAML that people like to read: a key a line, texts of several lines as they are.
std::string block_yaml(const nlohmann::ordered_json& map);

}  // namespace mien::pipeline
