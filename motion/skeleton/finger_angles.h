#pragma once

#include "motion/skeleton/hand.h"

namespace mien::motion {

/// How a finger joint is bent, degrees. Of the rotation of its bone only the direction counts.
struct FingerAngles {
  double flexion = 0.0;    ///< about flexion_axis (hand.h), towards the palm, in (−180, 180]
  double abduction = 0.0;  ///< out of the plane of flexion, in [−90, 90]
};

/// The angles of a joint of a pose that has fingers.
FingerAngles finger_angles(const Pose& pose, int finger_joint);

struct FingerRange {
  double least = 0.0;  ///< degrees
  double most = 0.0;
};

struct FingerRanges {
  FingerRange flexion;
  FingerRange abduction;
};

/// What hands can do, degrees. Flexion follows the norms of the American Academy of Orthopaedic
/// Surgeons (Greene and Heckman 1994: knuckles 90, middle joints 100, last joints 90; thumb 50 and
/// 80), extended to those of flexible people, and extension of the knuckles by 45. Sideways,
/// knuckles have 25 either way and the other joints of a finger almost nothing. How a thumb is
/// turned about itself differs between rigs, and so does where its base, a saddle joint, is at
/// rest: there only 80 either way are too much.
FingerRanges finger_ranges(int finger_joint);

}  // namespace mien::motion
