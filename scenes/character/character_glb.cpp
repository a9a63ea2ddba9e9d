#include "scenes/character/character_glb.h"

#include "scenes/skinning/skinned_glb.h"

namespace mien::scenes {

std::string to_glb(const Character& character) {
  SkinnedFigure figure{.bind = rig_bind_pose(character),
                       .body_joints = body_joint_of(character),
                       .meshes = character.meshes,
                       .materials = character.materials};
  for (const motion::Joint& joint : character.rig.joints) figure.joints.push_back(joint.name);
  for (const render::Texture& texture : character.textures) figure.textures.push_back(&texture);
  return skinned_glb(figure);
}

}  // namespace mien::scenes
