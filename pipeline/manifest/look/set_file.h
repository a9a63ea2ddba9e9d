#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/sets/set_plan.h"

namespace mien::pipeline {

/// Returns the names of the built-in sets: studio, void, treadmill, corridor, lab-grid.
std::vector<std::string> set_names();

/// Returns the text of a built-in set's file; empty for an unknown name.
std::string_view builtin_set_text(std::string_view name);

/// Returns the built-in set of that name; if there is none, the one in `file`. Throws Faults that
/// list the faults of the file, and Error if it cannot be read. Example of a file:
///
///     background: "#808080"
///     ground: {colour: "#dadada", lines: {every: 0.5, colour: "#bfc0c1"}}
///     lights: [{azimuth: -28, elevation: 52, strength: 0.6}]
scenes::SetPlan read_set(const std::string& name, const std::filesystem::path& file);
scenes::SetPlan parse_set(std::string_view yaml, const std::filesystem::path& file);

}  // namespace mien::pipeline
