#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/fbx/fbx_mesh.h"
#include "motion/formats/fbx/fbx_scene.h"
#include "scenes/character/bind_pose.h"
#include "scenes/character/character_parts.h"

namespace mien::scenes {

/// The figure of an FBX file in its bind pose. Nodes of the rig are models; the world is that of
/// the file with +Y up (motion::FbxSettings::to_y_up), in its unit.
struct FbxCharacter {
  motion::FbxScene scene;
  std::vector<motion::FbxMesh> meshes;  ///< those that are drawn
  BindPoseRig rig;                      ///< meshes and skins have the indices of `meshes`
};

/// Parses the figure with the most joints and its meshes; `bytes` must outlive the result. The bind
/// pose is that of the skins (TransformLink), or, where they do not state it, that of most of the
/// models at rest. Hidden meshes are omitted. Throws mien::Error if no mesh follows the figure.
FbxCharacter parse_fbx_character(std::string_view bytes, const std::string& name,
                                 std::vector<std::string>& warnings);

/// The materials of the file's meshes.
struct FbxPaint {
  CharacterMaterials paint;
  std::map<int, int> material_of;        ///< index in `paint` by object of the file
  std::map<int, std::string> uv_set_of;  ///< name of its set of coordinates, by object
};

/// Pictures are in the file, else in `folder` (none for a file in memory): under the relative name
/// that the file gives, or the last part of it there or in the folder "<file>.fbm". Surfaces
/// without a picture that can be read keep their plain colour, with a warning.
FbxPaint fbx_paint(const FbxCharacter& character,
                   const std::optional<std::filesystem::path>& folder,
                   std::vector<std::string>& warnings);

/// The meshes in the bind pose, one for each material of each mesh. Corners that differ in normal
/// or texture coordinates are vertices of their own. Throws mien::Error.
std::vector<SkinnedMesh> fbx_skinned_meshes(const FbxCharacter& character, const FbxPaint& paint,
                                            std::vector<std::string>& warnings);

/// The character of an FBX file.
CharacterParts fbx_parts(std::string_view bytes, const std::string& name,
                         const std::optional<std::filesystem::path>& folder);

/// The pictures beside an FBX file that its materials use, as far as they exist.
std::vector<std::filesystem::path> files_of_fbx(std::string_view bytes, const std::string& name,
                                                const std::filesystem::path& folder);

}  // namespace mien::scenes
