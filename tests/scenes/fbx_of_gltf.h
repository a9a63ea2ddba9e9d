#pragma once

#include <string>

#include "motion/formats/fbx/fbx_scene_builder.h"
#include "motion/math/geometry.h"

namespace mien::test {

/// How a glTF character is written as FBX.
struct FbxOfGltf {
  double units_per_metre = 100.0;  ///< and UnitScaleFactor to match
  bool z_up = false;               ///< +Z up, -Y to the front
  bool states_bind_pose = true;    ///< whether clusters have a TransformLink
  /// Transform of the geometry alone (GeometricTranslation, -Rotation, -Scaling).
  motion::Vec3 geometric_translation = motion::Vec3::Zero();
  motion::Vec3 geometric_degrees = motion::Vec3::Zero();
  double geometric_scale = 1.0;
  bool is_mirrored = false;  ///< below a model whose scale along x is −1
  bool embeds_pictures = true;
  std::string picture_name = "..\\textures\\skin.png";  ///< RelativeFilename
};

/// The skinned meshes of a glTF file with embedded buffers and pictures as an FBX scene: its nodes
/// as limbs, its first skin and the meshes with it, each with its materials and pictures.
FbxSceneBuilder fbx_of_gltf(const std::string& gltf, const FbxOfGltf& how = {});

/// A binary glTF file as text, with its buffer embedded.
std::string text_of_glb(const std::string& glb);

}  // namespace mien::test
