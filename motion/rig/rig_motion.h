#pragma once

#include <optional>
#include <vector>

#include "motion/rig/mapped_joint.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// World transforms of every frame of a recording, in the file's unit and axes.
std::vector<JointTransforms> world_frames(const Recording& recording);

/// A recording seen as a moving human body: it keeps the rig's joints and unit, but is rotated to
/// +Y up. Holds references to the rig and the joints.
struct RigMotion {
  const Skeleton& rig;
  const MappedJoints& joints;
  std::vector<JointTransforms> frames;
  double frames_per_second = 30.0;

  bool has(BodyJoint joint) const { return joints[joint].position >= 0; }
  bool turns(BodyJoint joint) const { return joints[joint].rotation() >= 0; }

  /// Position of a canonical joint, which the rig must have.
  Vec3 point(const JointTransforms& frame, BodyJoint joint) const;

  /// Rotation of the rig joint that the canonical joint follows, which must exist.
  const Quat& rotation(const JointTransforms& frame, BodyJoint joint) const;
};

/// Makes the RigMotion of a recording, rotated by `to_y_up`.
RigMotion rig_motion(const Recording& recording, const MappedJoints& joints, const Quat& to_y_up);

/// The rig with all rotations zero, as one frame.
JointTransforms zero_pose(const Skeleton& rig);

/// Thigh plus shank, mean of both sides and all frames, in the rig's unit.
double leg_length(const RigMotion& motion);

/// The next joint down the main chain from `joint` that the rig has; none for the ends (head,
/// wrists, toes).
std::optional<BodyJoint> next_present(const RigMotion& motion, BodyJoint joint);

/// Position of the farthest descendant or tip (fingers, crown) of the rig joint that `joint`
/// follows, in that rig joint's coordinates and in the rig's unit; averaged over all frames of the
/// motion. Joints named as parts of the face, such as eyes and jaw, do not count. Zero if there is
/// none.
Vec3 far_end(const RigMotion& motion, BodyJoint joint);

/// The axis (±X, ±Y, ±Z) nearest to the mean, over the frames, of the unit vector from the ankles'
/// midpoint to the chest (or the left shoulder).
struct UpAxis {
  Vec3 axis = Vec3::UnitY();
  double clearness = 1.0;  ///< length of the mean's component along `axis`; 1: always upright
};
UpAxis up_axis(const std::vector<JointTransforms>& world, const MappedJoints& joints);

/// The shortest rotation that takes an axis to +Y; 180° about X if the axis is −Y.
Quat turn_to_y_up(const Vec3& axis);

}  // namespace mien::motion
