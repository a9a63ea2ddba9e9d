#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A key of a displacement map: rotation of a joint, and translation of the root, at a time.
struct DisplacementKey {
  double seconds = 0.0;
  BodyJoint joint = Pelvis;
  Vec3 turn = Vec3::Zero();   ///< rotation vector, radians, in the parent's frame
  Vec3 shift = Vec3::Zero();  ///< root translation, metres, world space; for the pelvis only
};

struct DisplacementMapOptions {
  double amount = 1.0;
  double start_seconds = 0.0;  ///< start of the window; all keys lie inside the window
  double end_seconds = 0.0;    ///< end of the window: at most the end of the motion; in a loop at
                               ///< most one cycle after the start (the window may cross the seam)
};

/// Displacement mapping (Bruderlin and Williams 1995): a cubic spline through the keys of each
/// joint, with value and slope zero at the window's ends, is applied to the motion as an additional
/// rotation and translation. Outside the window the motion is unchanged. Throws Error if the window
/// is empty, too long or beyond the motion, a key does not lie inside it, two keys of one joint are
/// at the same time, or a key of another joint than the pelvis has a `shift`.
Clip displaced(const Clip& motion, const std::vector<DisplacementKey>& keys,
               const DisplacementMapOptions& options = {});

/// Keys that displace a motion by the difference of the mean postures, `styled` − `neutral`: for
/// each joint at a quarter, half and three quarters of the window.
std::vector<DisplacementKey> displacements_between(const Clip& neutral, const Clip& styled,
                                                   const DisplacementMapOptions& window);

}  // namespace mien::motion
