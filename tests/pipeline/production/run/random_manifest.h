#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::test {

/// A tiny manifest of options that the schema allows, drawn at random: any of them, beside each
/// other as they come. What excludes each other is not avoided. Files that it names lie in its
/// folder (see `write_random_files`).
nlohmann::json random_manifest(std::uint64_t seed);

/// The manifest without the options at these paths of faults ("stimuli[0].look.camera.target").
/// Empty when one cannot be left out.
std::optional<nlohmann::json> without_options(nlohmann::json manifest,
                                              const std::vector<std::string>& paths);

/// Motions: a walk, two frames of it, one frame, and a folder of two walks.
void write_random_files(const std::filesystem::path& folder);

}  // namespace mien::test
