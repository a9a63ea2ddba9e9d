#pragma once

#include <string_view>

namespace mien::motion {

/// Throws mien::Error, naming the file and the remedy, if its bytes are clearly not of the expected
/// format: an empty file, UTF-16 text, an image, a web page, an archive, another motion format.
/// Other invalid bytes are left to the file reader. `format` is the expected format
/// (Recording::format, PointRecording::format): "bvh", "amc", "gltf", "fbx", "mvnx", "c3d", "trc",
/// "npy", "npz", "json", "csv".
void require_kind(std::string_view bytes, std::string_view file, std::string_view format);

}  // namespace mien::motion
