#pragma once

#include <optional>
#include <vector>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// The parameter by which a curve is warped to a key, in θ'(t) = a(t)·θ(g(t)) + b(t).
enum class WarpBy {
  offset,  ///< change b and keep a = 1 (default)
  scale,   ///< change a and keep b = 0; where a curve is within 1° of its mean, change b instead
};

/// Constraint of one joint at a key.
struct JointKey {
  BodyJoint joint = Pelvis;
  Quat turn = Quat::Identity();  ///< rotation relative to the motion's rotation at the key, in the
                                 ///< parent's frame
  WarpBy by = WarpBy::offset;
};

/// One keyframe over an existing motion.
struct WarpKey {
  double seconds = 0.0;          ///< time in the motion
  std::optional<double> at;      ///< time of the key in the result, seconds; empty: not constrained
  std::vector<JointKey> joints;  ///< joints not listed are unconstrained
  Vec3 root_shift = Vec3::Zero();  ///< metres, world space
};

struct MotionWarpOptions {
  double amount = 1.0;  ///< factor of rotations, shifts and time changes
  double reach_seconds =
      0.3;  ///< duration before and after a group of keys over which the change fades in and out
  std::optional<double> duration_seconds;  ///< of the result; empty: that of the motion
};

/// Motion warping (Witkin and Popović 1995). The changes of the curves (motion_curves.h) are cubic
/// splines through the keys. Keys at most 2·`reach_seconds` apart form a group; the change is zero
/// more than `reach_seconds` before a group's first key or after its last. The time warp g is a
/// monotone cubic (Fritsch–Carlson) through the keys moved in time, with fixed ends. In a loop,
/// keys act across the seam.
///
/// Throws Error if an option is out of range, keys lie outside the motion or the result, two keys
/// are at the same time, or their order in the result differs from that in the motion.
Clip motion_warped(const Clip& motion, const std::vector<WarpKey>& keys,
                   const MotionWarpOptions& options = {});

/// The keyframes that warp `motion` to `styled` at the keytimes: all joint rotations, the root's
/// height, and the keytimes themselves. Both have the same number of keytimes, and both or neither
/// loop; throws Error otherwise.
std::vector<WarpKey> keys_towards(const Example& motion, const Example& styled);

/// The motion warped to the poses of `styled` at the keytimes and to its duration and travel, as if
/// an animator had edited those poses only.
Clip warped_towards(const Example& motion, const Example& styled,
                    const MotionWarpOptions& options = {});

}  // namespace mien::motion
