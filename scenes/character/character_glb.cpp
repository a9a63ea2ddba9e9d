#include "scenes/character/character_glb.h"

#include "scenes/skinning/skinned_glb.h"

namespace mien::scenes {

namespace {

/// The names of the file's morph targets: controls of targets follow those of expressions.
std::vector<std::string> morph_names(const FaceControls& face) {
  std::vector<std::string> names(static_cast<std::size_t>(face.morph_count));
  for (const FaceControl& control : face.controls)
    for (const auto& [morph, share] : control.morphs)
      names[static_cast<std::size_t>(morph)] = control.name;
  return names;
}

}  // namespace

std::string to_glb(const Character& character) {
  SkinnedFigure figure{.bind = rig_bind_pose(character),
                       .body_joints = body_joint_of(character),
                       .meshes = character.meshes,
                       .materials = character.materials,
                       .morphs = morph_names(character.face)};
  for (const motion::Joint& joint : character.rig.joints) figure.joints.push_back(joint.name);
  for (const render::Texture& texture : character.textures) figure.textures.push_back(&texture);
  return skinned_glb(figure);
}

}  // namespace mien::scenes
