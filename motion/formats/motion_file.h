#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Whether `read_motion` supports a file's extension.
bool is_motion_file(const std::filesystem::path& path);

/// Reads a motion by its file's extension: .bvh, .amc (with its .asf), .gltf, .glb. Throws
/// mien::Error: no such file, another extension, or what the reader of the format finds wrong.
/// `take` chooses a motion of a file that holds several (glTF); other formats refuse it.
Recording read_motion(const std::filesystem::path& path,
                      const std::optional<std::string>& take = std::nullopt);

/// As `read_motion`, where an empty `take` means the first of several motions.
Recording read_take(const std::filesystem::path& path, const std::string& take);

/// Whether a file of this extension may hold several motions to choose a take from.
bool may_hold_takes(const std::filesystem::path& path);

/// Writes a motion by its file's extension: .bvh, .glb. Throws mien::Error.
void write_motion(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion
