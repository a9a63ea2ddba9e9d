#pragma once

#include "motion/skeleton/body.h"
#include "motion/skeleton/pose.h"

namespace mien::scenes {

/// Frame of the trunk between hips and shoulders, independent of where the rig places its spine
/// joints (some place them all at the pelvis, others at the neck).
///
/// Levels are heights above the hips on the standard body, whose shoulders lie at `shoulder_level`;
/// they are scaled to other bodies. Metres at a stature of 1.75 m unless said otherwise.
struct Trunk {
  static constexpr double shoulder_level = 0.49;

  motion::Vec3 hips;       ///< midpoint of the hips, world space
  motion::Vec3 shoulders;  ///< midpoint of the shoulders, world space
  double scale;            ///< the body's relative stature
  double half_hips;        ///< distance from the midline to a hip joint
  double half_shoulders;   ///< distance from the midline to a shoulder joint

  double stretch() const;  ///< ratio of the trunk's height to the standard body's
  /// Breadth of the chest relative to the standard body's, clamped to the human range.
  double breadth() const;
  /// Breadth of the waist relative to the standard body's: the mean of the ratios of chest and
  /// hips.
  double waist() const;

  /// World position of a point given as (distance to the left, level, distance forward).
  motion::Vec3 at(const motion::Vec3& place) const;
};

/// The trunk of a body in its `modelling_pose`.
Trunk trunk_of(const motion::Skeleton& body, const motion::JointTransforms& pose);

/// Size and position of the head. Rigs place the head joint anywhere from the nape to the eyes, and
/// some end the head below the crown; real heads differ little.
struct HeadShape {
  double size;  ///< relative to the standard body's head
  /// Offset from the rig's head joint to where the standard head has its joint, in the joint's
  /// frame, metres.
  motion::Vec3 raise;
};

HeadShape head_shape(const motion::Skeleton& body);

/// Elevation of the clavicles, radians, at which the shoulders are as far below the head as on the
/// standard body, limited to ±20°, and reduced for short clavicles. Rigs whose clavicles begin at
/// the throat have them level in the rest pose and raised by about this angle in captured motions.
double collar_lift(const motion::Skeleton& body);

}  // namespace mien::scenes
