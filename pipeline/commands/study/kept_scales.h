#pragma once

#include <filesystem>
#include <optional>

namespace mien::pipeline {

/// The scales file that a study keeps beside its results, in inputs/; none where it was made with
/// the built-in pairs or keeps nothing. `study` is its folder, or its metrics/parameters.csv.
std::optional<std::filesystem::path> kept_scales(const std::filesystem::path& study);

}  // namespace mien::pipeline
