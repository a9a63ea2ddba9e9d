#pragma once

#include <filesystem>

#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Whether a file's extension is one that `read_motion` takes.
bool is_motion_file(const std::filesystem::path& path);

/// Reads a motion by its file's extension: .bvh, .amc (with its .asf), .gltf, .glb. Throws
/// mien::Error: no such file, another extension, or what the reader of the format finds wrong.
Recording read_motion(const std::filesystem::path& path);

/// Writes a motion by its file's extension: .bvh, .glb. Throws mien::Error.
void write_motion(const Recording& recording, const std::filesystem::path& path);

}  // namespace mien::motion
