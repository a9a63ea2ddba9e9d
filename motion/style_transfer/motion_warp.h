#pragma once

#include <optional>
#include <vector>

#include "motion/skeleton/example.h"

namespace mien::motion {

/// How a curve is warped to a key: θ'(t) = a(t)·θ(g(t)) + b(t) has two ways.
enum class WarpBy {
  offset,  ///< by b, a stays 1 (default)
  scale,   ///< by a, b stays 0; where a curve is within 1° of its mean, by b after all
};

/// Constraint of one joint at a key.
struct JointKey {
  BodyJoint joint = Pelvis;
  Quat turn = Quat::Identity();  ///< from the motion's rotation at the key, axes of the parent
  WarpBy by = WarpBy::offset;
};

/// One keyframe over an existing motion.
struct WarpKey {
  double seconds = 0.0;            ///< the moment of the motion
  std::optional<double> at;        ///< seconds of the result at which it is to be; else as it was
  std::vector<JointKey> joints;    ///< other joints are unconstrained
  Vec3 root_shift = Vec3::Zero();  ///< metres, world space
};

struct MotionWarpOptions {
  double amount = 1.0;  ///< of turns, shifts and moves in time
  double reach_seconds =
      0.3;  ///< from a key, and from every key of a group, to where nothing changes
  std::optional<double> duration_seconds;  ///< of the result; else the motion's
};

/// Motion warping (Witkin and Popović 1995). Curves (motion_curves.h) pass through the keys and run
/// as cubic splines between them; `reach_seconds` from the nearest key, where there is no other
/// within twice that, they are the motion again. Time runs monotonically through the moved keys
/// (g, Fritsch–Carlson), ends fixed. Keys of a loop work across its seam.
///
/// Throws Error when keys lie outside the motion or the result, two stand at the same moment, or
/// their order in the result is another than in the motion.
Clip motion_warped(const Clip& motion, const std::vector<WarpKey>& keys,
                   const MotionWarpOptions& options = {});

/// The keyframes that turn `motion` into `styled` at the keytimes: every joint, the root's height,
/// and the times themselves. Both have the same number of keytimes; throws Error otherwise.
std::vector<WarpKey> keys_towards(const Example& motion, const Example& styled);

/// The motion warped to the poses that another has at its keytimes, as an animator would who draws
/// only those; its duration too.
Clip warped_towards(const Example& motion, const Example& styled,
                    const MotionWarpOptions& options = {});

}  // namespace mien::motion
