#pragma once

#include <vector>

#include "motion/gestures/hand_hits.h"

namespace mien::motion {

struct HeldHands {
  Clip clip;
  double largest_correction = 0.0;  ///< metres
};

/// Moves the wrists so that at each hit they are where they are in the reference, a motion of the
/// same frames: in the world, or of motions that travel relative to the hips. Corrections fade
/// over 0.2 s (more if they are large) on both sides of a hit, or from one to the next; the arm
/// follows by inverse kinematics, the hand keeps its orientation. Corrections below 0.1 mm are not
/// made.
HeldHands with_held_hands(const Clip& clip, const Clip& reference, const std::vector<HandHit>& hits,
                          bool travels);

}  // namespace mien::motion
