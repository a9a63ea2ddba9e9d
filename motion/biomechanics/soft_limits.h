#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The value, smoothly compressed so that it never exceeds `limit`: unchanged up to `start`, then
/// start + m·(1 − exp(−(value − start)/m)), m = limit − start > 0.
double softly_limited(double value, double start, double limit);

/// Extremes of the limited joint angles of a motion.
struct TurnExtremes {
  struct Extreme {
    double least = 0.0, most = 0.0;  ///< radians
  };
  std::vector<Extreme> turns;  ///< per limited angle; empty before the first pose
};

void widen(TurnExtremes& extremes, const Pose& pose);

/// Limits the joints of one pose as `with_soft_limits` does, for an original with the joint ranges
/// `known` (at least one pose). Returns the largest correction, radians.
double limit_softly(Pose& pose, const TurnExtremes& known);

/// Result of soft joint limits.
struct SoftLimits {
  Clip clip;
  double largest_excess = 0.0;  ///< largest correction of a joint, radians
};

/// The clip with soft limits on the flexion of knees, elbows, ankles and hips, the abduction of
/// hips and the bend of wrists: angles are compressed over the last 15° before the unloaded limits
/// of joint_angles.h. Angles that `original` reaches are never corrected, even beyond a limit; the
/// compression then extends over at least 12° beyond them (3° for a straight knee or elbow),
/// because a harder stop would be visible as a jerk.
SoftLimits with_soft_limits(const Clip& clip, const Clip& original);

}  // namespace mien::motion
