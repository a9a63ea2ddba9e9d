#pragma once

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::scenes {

/// Where the flesh of the trunk hangs: between the hips and the shoulders, wherever the rig has the
/// joints of its spine (some lie all on the pelvis, some at the neck).
///
/// Levels are heights above the hips as on the standard body, whose shoulders lie at
/// `shoulder_level`; on others they stretch. Metres at a stature of 1.75 m unless said otherwise.
struct Trunk {
  static constexpr double shoulder_level = 0.49;

  motion::Vec3 hips;       ///< between the hips, world space
  motion::Vec3 shoulders;  ///< between the shoulders, world space
  double scale;            ///< the body's relative stature
  double half_hips;        ///< from the middle to a hip joint
  double half_shoulders;   ///< from the middle to a shoulder joint

  double stretch() const;  ///< height of the trunk by that of the standard body's
  double breadth() const;  ///< of the chest, likewise; within what chests have
  double waist() const;    ///< breadth of the waist, likewise: between chest and hips

  /// World position of (left, level, forward).
  motion::Vec3 at(const motion::Vec3& place) const;
};

/// For a body that stands upright as it is modelled (`modelling_pose`).
Trunk trunk_of(const motion::Skeleton& body, const motion::JointTransforms& pose);

/// How large the head is, and where: rigs have the joint of the head anywhere from the nape to the
/// eyes, and some an end of the head that is not the crown, but heads differ by little.
struct HeadShape {
  double size;         ///< by that of the standard body's head
  motion::Vec3 raise;  ///< from the joint to where the standard head has it, in the joint's frame
};

HeadShape head_shape(const motion::Skeleton& body);

/// How far collar bones are turned upward, radians, for the shoulders to lie as far below the head
/// as they do on the standard body. Rigs whose collar bones begin at the throat have them level in
/// the rest pose, and turned by about this much whenever somebody moves.
double collar_lift(const motion::Skeleton& body);

}  // namespace mien::scenes
