#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien::pipeline {

/// Compares the sounds of two videos. `remarks` receives audible differences: a sound that is
/// missing or new, another duration (by more than a packet, 1024 sample frames), a shift, another
/// loudness (by more than 0.5 LU), or another sound (a correlation below 0.8). `notes` receives
/// another codec, and samples that differ by less, as after encoding anew. Adds nothing if neither
/// has a sound. Throws Error if a sound cannot be decoded.
void compare_sounds(const std::filesystem::path& before, const std::filesystem::path& now,
                    std::vector<std::string>& remarks, std::vector<std::string>& notes);

}  // namespace mien::pipeline
