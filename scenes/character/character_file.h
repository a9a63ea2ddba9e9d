#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_nodes.h"
#include "motion/skeleton/skeleton.h"
#include "render/scene/scene.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// A parsed glTF file. Its indices are not yet checked.
struct CharacterFile {
  motion::GltfFile gltf;
  motion::GltfNodes nodes;
  nlohmann::json json;
  std::optional<std::filesystem::path> folder;  ///< of external files; none for a file in memory
};

CharacterFile parse_character_file(std::string_view bytes, const std::string& name,
                                   const std::optional<std::filesystem::path>& folder);

/// An instance of a mesh in the file.
struct PlacedMesh {
  int node = -1;
  int mesh = -1;
  int skin = -1;   ///< skin that deforms it; −1: it is attached to a joint
  int joint = -1;  ///< joint of the rig that a mesh without a skin is attached to
  /// For an attached mesh: mesh space → bind pose.
  Eigen::Affine3d to_world = Eigen::Affine3d::Identity();
};

/// The joints of all skins in use and the nodes between them, in their bind pose.
struct BindPoseRig {
  std::vector<PlacedMesh> meshes;
  std::vector<int> nodes;             ///< node of each joint of `skeleton`
  std::vector<int> joint_of_node;     ///< −1 for nodes that are not joints
  motion::Skeleton skeleton;          ///< bind pose, frames parallel to the file's world
  std::vector<Eigen::Affine3d> bind;  ///< world transform of each joint
  bool is_mirrored = false;  ///< whether the meshes are stored as the figure's mirror image

  /// For each skin and each of its joints: mesh space → world in the bind pose; empty for skins
  /// that are not in use.
  std::vector<std::vector<Eigen::Affine3d>> skin_to_world;
};

/// Throws mien::Error when there is no skin, a joint does not exist or the matrices do not form a
/// pose.
BindPoseRig bind_pose_rig(const CharacterFile& file, std::vector<std::string>& warnings);

/// All primitives in the bind pose, in the file's world space. Material 0 is a default; the file's
/// own materials follow. Throws mien::Error.
std::vector<SkinnedMesh> character_meshes(const CharacterFile& file, const BindPoseRig& rig,
                                          std::vector<std::string>& warnings);

/// The materials of a file (the first is a default) and the textures that they use. Throws
/// mien::Error when a picture is missing or does not decode.
struct CharacterMaterials {
  std::vector<render::Material> materials;
  std::vector<render::Texture> textures;
};
CharacterMaterials character_materials(const CharacterFile& file,
                                       std::vector<std::string>& warnings);

/// The JSON list under `key`; empty when there is none.
const nlohmann::json& list_in(const nlohmann::json& object, const char* key);

/// The index under `key`, −1 when there is none. Throws mien::Error when it is not an integer from
/// 0 to count − 1; `use` names it in the message: "mesh 3, material".
int index_in(const CharacterFile& file, const nlohmann::json& object, const char* key, size_t count,
             const std::string& use);

}  // namespace mien::scenes
