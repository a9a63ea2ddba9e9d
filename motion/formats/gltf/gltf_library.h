#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

namespace mien::motion {

/// The nodes, skins, animations and buffers of a glTF file. Indices, counts and offsets have not
/// been checked.
struct GltfFile {
  std::string name;  ///< for error messages
  tinygltf::Model model;
  std::vector<int> human_nodes = {};  ///< the bones of a VRM file, named as VRM does; else empty
};

/// Parses a text or binary glTF file, VRM files among them: the nodes of their bones get VRM's
/// names, "hips" and "leftUpperArm", in place of their own. Buffer files are read from `folder`;
/// without it they are refused. Meshes are not read, but nodes still show that they have one;
/// materials and images are ignored. Throws mien::Error.
GltfFile parse_gltf_file(std::string_view bytes, const std::string& name,
                         const std::optional<std::filesystem::path>& folder);

/// The JSON text of a text or binary glTF file. Throws mien::Error if a binary file is truncated or
/// is not of version 2.
std::string_view gltf_json_text(std::string_view bytes, const std::string& name);

/// A relative URI as a path: "a%20walk.bin" names the file "a walk.bin".
std::string path_of_gltf_uri(const std::string& uri);

/// The bytes of a data URI, or of the file in `folder` that the URI names. `use` states the purpose
/// of the bytes in error messages: "buffer". Throws mien::Error.
std::vector<unsigned char> bytes_of_gltf_uri(const std::string& uri, const std::string& name,
                                             const std::optional<std::filesystem::path>& folder,
                                             std::string_view use);

/// The remedy for an invalid file.
inline constexpr std::string_view get_it_again = "export or download the file again";

/// Throws mien::Error with the name of the file.
[[noreturn]] void refuse(const GltfFile& file, std::string_view wrong, std::string_view remedy);

}  // namespace mien::motion
