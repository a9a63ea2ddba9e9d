#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A key of a displacement map: rotation of a joint, and translation of the root, at a time.
struct DisplacementKey {
  double seconds = 0.0;
  BodyJoint joint = Pelvis;
  Vec3 turn = Vec3::Zero();   ///< rotation vector, radians, axes of the parent's frame
  Vec3 shift = Vec3::Zero();  ///< metres, world space; of the root, so only with the pelvis
};

struct DisplacementMapOptions {
  double amount = 1.0;
  double start_seconds = 0.0;  ///< of the window; its keys lie inside
  double end_seconds = 0.0;  ///< of the window; not after the motion, or within one cycle's length
                             ///< from the start in a loop (then it may cross the seam)
};

/// Displacement mapping (Bruderlin and Williams 1995): a cubic spline through the keys of each
/// joint, zero with zero slope at the window's ends, is turned onto the motion. Outside the window
/// nothing changes. Throws Error when the window is empty or too long, or a key is not inside it,
/// or two of one joint are at the same moment.
Clip displaced(const Clip& motion, const std::vector<DisplacementKey>& keys,
               const DisplacementMapOptions& options = {});

/// Keys of one joint each that move the motion by the difference of mean postures, `styled` less
/// `neutral`, through the window: at a quarter, half and three quarters of it.
std::vector<DisplacementKey> displacements_between(const Clip& neutral, const Clip& styled,
                                                   const DisplacementMapOptions& window);

}  // namespace mien::motion
