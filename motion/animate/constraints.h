#pragma once

#include <vector>

#include "motion/animate/animation_report.h"
#include "motion/animate/constraint.h"

namespace mien::motion {

/// The motion with all constraints, frame by frame (per-frame inverse kinematics, Gleicher 2001):
/// each acts in full from `from` to `to` and fades out before and after, over `reach` seconds, with
/// continuous acceleration. Frames on which none acts are not touched; a loop stays a loop.
///
/// Limbs reach their places as those of keys do (keys.h). Regions, distances and ranges act from
/// shortly before their limits on (5 cm, 5°), so that they are approached smoothly. If two parts at
/// a distance are both hands, each goes half of the way; otherwise the hand goes. Where a joint
/// would leave its range farther than without the constraints (joint_angles.h), they act less, and
/// `misses` says by how much each is missed at most, and when.
///
/// Throws mien::Error for moments outside the motion or out of order, for a place in the room that
/// is to be held throughout a loop which travels, and for a skeleton other than the canonical body.
AnimatedClip with_constraints(const Clip& clip, const std::vector<MotionConstraint>& constraints);

}  // namespace mien::motion
