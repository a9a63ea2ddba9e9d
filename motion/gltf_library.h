#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <tiny_gltf.h>

namespace mien::motion {

/// What a glTF file says of nodes, skins and animations, and the bytes of its buffers. Nothing else
/// of it has been checked: indices, counts and offsets are the file's own.
struct GltfFile {
  std::string name;  ///< for error messages
  tinygltf::Model model;
};

/// Parses a text or binary glTF file; `folder` holds its buffer files, none may be read without it.
/// Meshes that belong to nodes count as present but are not read, nor are materials and images.
/// Throws mien::Error.
GltfFile parse_gltf_file(std::string_view bytes, const std::string& name,
                         const std::optional<std::filesystem::path>& folder);

/// Throws mien::Error naming the file.
[[noreturn]] void refuse(const GltfFile& file, std::string_view wrong, std::string_view remedy);

}  // namespace mien::motion
