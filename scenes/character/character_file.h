#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_nodes.h"
#include "scenes/character/bind_pose.h"
#include "scenes/character/character_parts.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

struct GltfMorphs;

/// A parsed glTF file. Its indices are not yet checked.
struct CharacterFile {
  motion::GltfFile gltf;
  motion::GltfNodes nodes;
  nlohmann::json json;
  std::optional<std::filesystem::path> folder;  ///< of external files; none for a file in memory
};

CharacterFile parse_character_file(std::string_view bytes, const std::string& name,
                                   const std::optional<std::filesystem::path>& folder);

/// Throws mien::Error when there is no skin, a joint does not exist or the matrices do not form a
/// pose.
BindPoseRig gltf_rig(const CharacterFile& file, std::vector<std::string>& warnings);

/// All primitives in the bind pose, in the file's world space. Material 0 is a default; the file's
/// own materials follow. Throws mien::Error.
std::vector<SkinnedMesh> gltf_meshes(const CharacterFile& file, const BindPoseRig& rig,
                                     const GltfMorphs& morphs, std::vector<std::string>& warnings);

/// The materials of a file (the first is a default) and the textures that they use. Throws
/// mien::Error when a picture is missing or does not decode.
CharacterMaterials gltf_materials(const CharacterFile& file, std::vector<std::string>& warnings);

/// The JSON list under `key`; empty when there is none.
const nlohmann::json& list_in(const nlohmann::json& object, const char* key);

/// The index under `key`, −1 when there is none. Throws mien::Error when it is not an integer from
/// 0 to count − 1; `use` names it in the message: "mesh 3, material".
int index_in(const CharacterFile& file, const nlohmann::json& object, const char* key, size_t count,
             const std::string& use);

}  // namespace mien::scenes
