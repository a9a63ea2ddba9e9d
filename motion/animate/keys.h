#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/animate/animation_report.h"
#include "motion/animate/body_end.h"
#include "motion/animate/moment.h"

namespace mien::motion {

inline constexpr double usual_reach_seconds = 0.5;

/// Where parts of the body are to be at one moment.
struct AnimatorKey {
  Moment at;
  /// Places by BodyEnd, metres; a head has none (see `look_at`).
  std::array<std::optional<Vec3>, body_ends.size()> places;
  std::optional<Vec3> look_at;  ///< the place at which the face is directed, metres
  PlaceFrame frame = PlaceFrame::body;
  double reach = usual_reach_seconds;  ///< seconds before and after, in which the motion changes
};

/// The motion with its hands, feet, pelvis and gaze at the keys' places at the keys' moments, by
/// motion warping in end positions: the differences at the keys are interpolated by displacement
/// curves (displacement_curve.h), those of hands as rotations about the shoulder and changes of the
/// distance from it; limbs follow by inverse kinematics (pose_change.h). Frames
/// outside the reach of all keys are not touched. A loop stays a loop.
///
/// Out of an arm's reach the trunk leans, by at most 60°; out of a leg's reach the pelvis moves, by
/// at most 0.3 m; the trunk turns with a gaze of more than 60° to the side, by at most 60°. A joint
/// that would leave its range (joint_angles.h) farther than it does without the key stops
/// the key as near as it comes. Feet stay planted: a key of a planted foot moves the whole contact,
/// and reaches are cut where another contact of that foot begins or ends; when the pelvis moves,
/// the feet stay. `misses` says which keys could not be held.
///
/// Throws mien::Error for a moment outside the motion, two keys of one part at the same moment, a
/// reach that is not positive, and for a skeleton other than the canonical body.
AnimatedClip with_keys(const Clip& clip, const std::vector<AnimatorKey>& keys);

}  // namespace mien::motion
