#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

namespace mien::motion {

/// The nodes, skins, animations and buffers of a glTF file. Its indices, counts and offsets are not
/// yet checked.
struct GltfFile {
  std::string name;  ///< for error messages
  tinygltf::Model model;
};

/// Parses a text or binary glTF file; `folder` holds its buffer files, none may be read without it.
/// Meshes that belong to nodes count as present but are not read, nor are materials and images.
/// Throws mien::Error.
GltfFile parse_gltf_file(std::string_view bytes, const std::string& name,
                         const std::optional<std::filesystem::path>& folder);

/// The JSON text of a text or binary glTF file. Throws mien::Error when the file was cut short.
std::string_view gltf_json_text(std::string_view bytes, const std::string& name);

/// A relative URI as a path: "a%20walk.bin" names the file "a walk.bin".
std::string path_of_gltf_uri(const std::string& uri);

/// The bytes of a data URI or of the file that a URI names in `folder`. `use`
/// says what it is for: "buffer". Throws mien::Error.
std::vector<unsigned char> bytes_of_gltf_uri(const std::string& uri, const std::string& name,
                                             const std::optional<std::filesystem::path>& folder,
                                             std::string_view use);

/// The remedy for a file that was written wrongly.
inline constexpr std::string_view get_it_again = "export or download the file again";

/// Throws mien::Error with the file's name.
[[noreturn]] void refuse(const GltfFile& file, std::string_view wrong, std::string_view remedy);

}  // namespace mien::motion
