#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/fbx/fbx_objects.h"
#include "motion/math/geometry.h"

namespace mien::motion {

/// A node of the scene as the file describes it. Lengths are in the file's unit, angles in degrees.
struct FbxModel {
  /// How scales of parents take effect: on rotated axes, with shear (RSrs); without shear (RrSs);
  /// or without the scale of the parent itself (Rrs).
  enum class Inherit { RrSs, RSrs, Rrs };

  int object = -1;
  std::string name;
  std::string_view kind;  ///< "LimbNode", "Null", "Mesh"
  int parent = -1;        ///< index of the model; −1 for those at the top
  std::vector<int> children;

  Vec3 translation = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();
  Vec3 scale = Vec3::Ones();
  Vec3 rotation_offset = Vec3::Zero();
  Vec3 rotation_pivot = Vec3::Zero();
  Vec3 pre_rotation = Vec3::Zero();
  Vec3 post_rotation = Vec3::Zero();
  Vec3 scaling_offset = Vec3::Zero();
  Vec3 scaling_pivot = Vec3::Zero();
  Vec3 geometric_translation = Vec3::Zero();  ///< of the geometry alone, not of children
  Vec3 geometric_rotation = Vec3::Zero();
  Vec3 geometric_scaling = Vec3::Ones();
  /// 0 XYZ (X is applied first), 1 XZY, 2 YZX, 3 YXZ, 4 ZXY, 5 ZYX; 0 if it does not count.
  int rotation_order = 0;
  Inherit inherit = Inherit::RrSs;
  bool rotation_is_active = false;  ///< whether order, pre- and post-rotation count
  bool is_for_limits_only = false;  ///< whether they count for limits alone

  Quat before = Quat::Identity();  ///< the pre-rotation, if it counts
  Quat after = Quat::Identity();   ///< the inverse of the post-rotation, if it counts
};

/// What moves in a model.
struct FbxMoving {
  Vec3 translation = Vec3::Zero();
  Vec3 rotation = Vec3::Zero();  ///< degrees
  Vec3 scale = Vec3::Ones();
  /// Rotations of further animation layers, applied before `rotation`.
  Quat layered_rotation = Quat::Identity();
};

FbxMoving at_rest(const FbxModel& model);

/// Position and orientation of a model in the world, or relative to its parent. `linear` has the
/// scales that `rotation` leaves out.
struct FbxPlace {
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Mat3 linear = Mat3::Identity();
  Vec3 own_scale = Vec3::Ones();  ///< of the model itself
};

/// A rotation by angles in degrees in one of the orders of `FbxModel::rotation_order`.
Quat rotation_of_angles(const Vec3& degrees, int order);

/// The place in the world of a child of `parent`: with local matrix T · Roff · Rp · Rpre · R ·
/// Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S · Sp⁻¹ and scales inherited as the model says.
FbxPlace place_below(const FbxPlace& parent, const FbxModel& model, const FbxMoving& moving);

/// The models of a file, those of one parent in the order of its connections. Throws mien::Error if
/// they form a cycle or a chain of more than
/// 1024, or if there are more than 131,072.
std::vector<FbxModel> parse_fbx_models(const FbxDocument& document, const FbxObjects& objects);

/// All models, depth first (parents before children).
std::vector<int> parents_first(const std::vector<FbxModel>& models);

}  // namespace mien::motion
