#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A value that would pass `limit` bent back so that it never does: unchanged up to `start`, then
/// start + m·(1 − exp(−(value − start)/m)), m = limit − start > 0.
double softly_limited(double value, double start, double limit);

/// Extremes of the limited joint angles of a motion.
struct TurnExtremes {
  struct Extreme {
    double least = 0.0, most = 0.0;  ///< radians
  };
  std::vector<Extreme> turns;  ///< empty before the first pose
};

void widen(TurnExtremes& extremes, const Pose& pose);

/// Limits the joints of one pose as `with_soft_limits` does, for an original with the extremes
/// `known`, which include at least one pose. Returns the largest correction, radians.
double limit_softly(Pose& pose, const TurnExtremes& known);

/// Result of soft joint limits.
struct SoftLimits {
  Clip clip;
  double largest_excess = 0.0;  ///< radians that some joint was bent back
};

/// The clip with the flexion of knees, elbows, ankles and hips, the abduction of hips and the bend
/// of wrists bent back softly over the last 15° before the limits that joint_angles.h gives them
/// without load. What `original` does is left, though it
/// be beyond, and has at least 12° to bend back in: a harder stop would be seen as a jerk.
SoftLimits with_soft_limits(const Clip& clip, const Clip& original);

}  // namespace mien::motion
