#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "pipeline/regression/baseline.h"

namespace mien::pipeline {

// Conversion of a baseline to and from its JSON files: baseline.json, and stimulus.json of each
// stimulus.

inline constexpr int baseline_version = 1;

/// The beginning of the last member of baseline.json, a hash of all preceding text.
inline constexpr std::string_view checksum_key = "\"checksum\": \"";

nlohmann::ordered_json json_of(const StimulusFacts& facts);
nlohmann::ordered_json json_of(const Approval& approval);

/// Throw nlohmann::json::exception for missing or malformed members, and std::logic_error if a
/// frame's name is not a number.
StimulusFacts stimulus_facts_of(const nlohmann::ordered_json& json);
Approval approval_of(const nlohmann::ordered_json& json);

}  // namespace mien::pipeline
