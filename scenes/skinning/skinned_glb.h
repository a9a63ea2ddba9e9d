#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/pose.h"
#include "render/scene/scene.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// Everything that a skinned figure is drawn from; borrowed, outlives the call.
struct SkinnedFigure {
  std::vector<std::string> joints;  ///< names, in the order of the influences' indices
  motion::JointTransforms bind;     ///< of these joints, world space, metres
  std::vector<int> body_joints;     ///< the joint of the body that each one goes with
  const std::vector<SkinnedMesh>& meshes;
  const std::vector<render::Material>& materials;
  std::vector<const render::Texture*> textures;  ///< of the materials
};

/// The figure in its bind pose as a GLB file (glTF 2.0): +Y up, metres.
///
/// Node j is joint j, a child of none, so that whoever poses it sets world transforms; its `extras`
/// tell its "body_joint". A vertex follows the four joints that move it most, their weights brought
/// to 1 again, for so many do all readers of glTF know. Emission is left out. Throws Error when a
/// texture cannot be written.
std::string skinned_glb(const SkinnedFigure& figure);

}  // namespace mien::scenes
