#pragma once

#include "motion/math/geometry.h"

namespace mien::motion {

/// A limb of two bones: hip–knee–ankle or shoulder–elbow–wrist. World positions, metres.
struct TwoBoneLimb {
  Vec3 root;
  Vec3 middle;
  Vec3 end;
};

/// Turns to multiply from the left onto the world rotations of the limb's two bones.
struct TwoBoneSolution {
  Quat upper_turn = Quat::Identity();
  Quat lower_turn = Quat::Identity();
  Vec3 middle;  ///< where the middle joint comes to stand
  Vec3 end;     ///< where the end comes to stand: the target, when it can be reached
};

/// Moves the limb's end to `target`, bone lengths kept. The plane of the bend turns with the line
/// from root to end and is otherwise kept (knee plane). `bend_hint` is the direction in which the
/// middle joint should lie off that line; it takes over, smoothly, as the limb comes within 10° of
/// straight, where the bend's direction is ill-defined. A target out of reach is
/// approached as far as `max_extension` (share of the two bones' summed length) allows.
TwoBoneSolution solve_two_bone(const TwoBoneLimb& limb, const Vec3& target, const Vec3& bend_hint,
                               double max_extension = 0.9999);

}  // namespace mien::motion
