#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "pipeline/regression/baseline.h"

namespace mien::pipeline {

// How a baseline stands in its files: baseline.json, and stimulus.json of each stimulus.

inline constexpr int baseline_version = 1;

/// Begins the last member of baseline.json, the hash of all text before it.
inline constexpr std::string_view checksum_key = "\"checksum\": \"";

nlohmann::ordered_json json_of(const StimulusFacts& facts);
nlohmann::ordered_json json_of(const Approval& approval);

/// Throw nlohmann::json::exception for what lacks members or has others in their place, and
/// std::logic_error where a frame's name is no number.
StimulusFacts stimulus_facts_of(const nlohmann::ordered_json& json);
Approval approval_of(const nlohmann::ordered_json& json);

}  // namespace mien::pipeline
