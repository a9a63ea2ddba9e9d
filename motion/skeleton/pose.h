#pragma once

#include <vector>

#include "motion/math/geometry.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// One moment of a skeleton.
struct Pose {
  Vec3 root_position = Vec3::Zero();  ///< of joint 0, world space
  std::vector<Quat> rotations;        ///< joint frame → parent frame, unit, one per joint
  std::vector<Vec3>
      offsets;  ///< per-frame joint offsets that replace the skeleton's; usually empty
  /// Rotations of the joints of both hands (hand.h), joint frame → parent frame, unit: all
  /// finger_joint_count of them, or none. Only poses of the canonical body have any, and within a
  /// clip all poses or none.
  std::vector<Quat> fingers = {};
};

/// World positions and rotations of all joints.
struct JointTransforms {
  std::vector<Vec3> positions;
  std::vector<Quat> rotations;
};

/// Forward kinematics. The root is at `pose.root_position`; its offset in the skeleton is not
/// added.
JointTransforms world_transforms(const Skeleton& skeleton, const Pose& pose);

/// Forward kinematics, positions only.
std::vector<Vec3> world_positions(const Skeleton& skeleton, const Pose& pose);

/// Slerp of the rotations and linear interpolation of the positions; t in [0, 1]. Fingers are
/// those of the one pose that has them, if not both have.
Pose interpolate(const Pose& from, const Pose& to, double t);

/// World position and rotation of one joint.
struct JointTransform {
  Vec3 position;
  Quat rotation;
};

/// Forward kinematics of one joint, from its ancestors alone.
JointTransform world_transform(const Skeleton& skeleton, const Pose& pose, int joint);

}  // namespace mien::motion
