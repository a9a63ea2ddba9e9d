#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/formats/gltf_library.h"
#include "motion/formats/gltf_nodes.h"
#include "motion/skeleton/skeleton.h"
#include "render/scene/scene.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// A glTF file with everything that a character is made of. Indices are the file's own, unchecked.
struct CharacterFile {
  motion::GltfFile gltf;
  motion::GltfNodes nodes;
  nlohmann::json json;
  std::optional<std::filesystem::path> folder;
};

CharacterFile parse_character_file(std::string_view bytes, const std::string& name,
                                   const std::optional<std::filesystem::path>& folder);

/// A mesh of the file where it stands.
struct PlacedMesh {
  int node = -1;
  int mesh = -1;
  int skin = -1;   ///< that it follows; −1: it hangs on a joint
  int joint = -1;  ///< of the rig, that a mesh without a skin hangs on
  Eigen::Affine3d to_world = Eigen::Affine3d::Identity();  ///< then: mesh space → bind pose
};

/// The joints of all skins in use, in their bind pose, and what is between them.
struct BoundRig {
  std::vector<PlacedMesh> meshes;
  std::vector<int> nodes;             ///< of each joint of `skeleton`
  std::vector<int> joint_of_node;     ///< −1 for nodes that are no joints
  motion::Skeleton skeleton;          ///< bind pose, frames parallel to the file's world
  std::vector<Eigen::Affine3d> bind;  ///< world transform of each joint
  bool is_mirrored = false;           ///< the file shows the mirror image of what was modelled

  /// For each skin and each of its joints: mesh space → world in the bind pose.
  std::vector<std::vector<Eigen::Affine3d>> skin_to_world;
};

/// Throws mien::Error when there is no skin, a joint does not exist or the numbers make no pose.
BoundRig bound_rig(const CharacterFile& file, std::vector<std::string>& warnings);

/// All primitives in the bind pose, in the file's world. Material 0 is a plain one, the file's own
/// follow. Throws mien::Error.
std::vector<SkinnedMesh> character_meshes(const CharacterFile& file, const BoundRig& rig,
                                          std::vector<std::string>& warnings);

/// Materials (the first is plain) and the textures that they use. Throws mien::Error when a picture
/// is missing or does not decode.
struct CharacterPaint {
  std::vector<render::Material> materials;
  std::vector<render::Texture> textures;
};
CharacterPaint character_paint(const CharacterFile& file, std::vector<std::string>& warnings);

/// A list that stands in the JSON under `key`; empty when there is none.
const nlohmann::json& list_in(const nlohmann::json& object, const char* key);

/// The index that stands under `key`, −1 when there is none. Throws mien::Error when it is no whole
/// number from 0 to below `count`; `use` says what it is: "mesh 3, material".
int index_in(const CharacterFile& file, const nlohmann::json& object, const char* key, size_t count,
             const std::string& use);

}  // namespace mien::scenes
