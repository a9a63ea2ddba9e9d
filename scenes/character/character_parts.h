#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/skeleton.h"
#include "render/scene/scene.h"
#include "scenes/character/face_control.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// The materials of a character, of which the first is a default, and their textures.
struct CharacterMaterials {
  std::vector<render::Material> materials;
  std::vector<render::Texture> textures;
};

/// The material of surfaces for which the file names none.
inline render::Material plain_material() { return {render::Color(0.6f, 0.6f, 0.6f), 0.03f, 0.5f}; }

/// What a file of any format says of a character, in its bind pose and in the file's world and
/// unit.
struct CharacterParts {
  std::string file;          ///< for messages
  motion::Skeleton rig;      ///< joint frames parallel to the world's
  bool is_mirrored = false;  ///< whether the meshes are stored as the figure's mirror image
  std::vector<SkinnedMesh> meshes;
  CharacterMaterials paint;
  FaceControls face;
  std::vector<std::string> warnings;
};

}  // namespace mien::scenes
