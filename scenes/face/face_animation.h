#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/face/face_track.h"

namespace mien::scenes {

/// Whether a path has the ending of a glTF file: .gltf, .glb, .vrm, .vrma.
bool is_gltf_file(const std::filesystem::path& path);

/// The weights that an animation of a glTF file gives to morph targets, by their names, and those
/// of the expressions of a VRM animation. `take` names the animation; if it is empty, the first one
/// with weights is read. Weights are what the file states, also below 0 and above 1. If several
/// meshes have a target of one name, the first with a curve counts.
///
/// Throws mien::Error if there is no such animation, and for faulty curves.
motion::FaceTrack read_face_animation(const std::filesystem::path& path, const std::string& take);

/// As `read_face_animation`, for a file in memory with all buffers embedded.
motion::FaceTrack parse_face_animation(std::string_view bytes, const std::string& file_name,
                                       const std::string& take);

}  // namespace mien::scenes
