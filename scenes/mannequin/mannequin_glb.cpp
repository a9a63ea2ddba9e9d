#include "scenes/mannequin/mannequin_glb.h"

#include <vector>

#include "scenes/skinning/skinned_glb.h"

namespace mien::scenes {

std::string to_glb(const Mannequin& mannequin, const motion::Skeleton& body) {
  const std::vector<SkinnedMesh> meshes = {mannequin.mesh};
  const std::vector<render::Material> materials = {mannequin_skin(0)};
  SkinnedFigure figure{.bind = mannequin.bind,
                       .meshes = meshes,
                       .materials = materials,
                       .textures = {&mannequin.paint}};
  for (const motion::Joint& joint : body.joints) {
    figure.body_joints.push_back(static_cast<int>(figure.joints.size()));
    figure.joints.push_back(joint.name);
  }
  return skinned_glb(figure);
}

}  // namespace mien::scenes
