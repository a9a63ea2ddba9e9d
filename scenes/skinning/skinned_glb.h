#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/pose.h"
#include "render/scene/scene.h"
#include "scenes/skinning/skinned_model.h"

namespace mien::scenes {

/// A skinned figure for export. References must outlive the call.
struct SkinnedFigure {
  /// Names of the joints, in the order of the influences' indices.
  std::vector<std::string> joints;
  motion::JointTransforms bind;  ///< bind transforms of these joints, world space, metres
  std::vector<int> body_joints;  ///< the joint of the body that each one follows
  const std::vector<SkinnedMesh>& meshes;
  const std::vector<render::Material>& materials;
  std::vector<const render::Texture*> textures;  ///< textures of the materials
  std::vector<std::string> morphs = {};  ///< name of each morph of the meshes (MorphTarget::morph)
};

/// The figure in its bind pose as a GLB file (glTF 2.0): +Y up, metres.
///
/// Node j is joint j, without a parent, so that it is posed by world transforms; its `extras`
/// contain its "body_joint". A vertex keeps only its four largest weights, renormalised, because
/// some glTF viewers do not support more. Emission is omitted.
///
/// Meshes without morph targets are one mesh of the file, each other one has its own, with the
/// names of its targets ("targetNames") and their morphs ("morphs") in its `extras`. Throws Error
/// when a texture cannot be written.
std::string skinned_glb(const SkinnedFigure& figure);

}  // namespace mien::scenes
