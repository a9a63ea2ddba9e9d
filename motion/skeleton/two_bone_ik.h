#pragma once

#include "motion/math/geometry.h"

namespace mien::motion {

/// A limb of two bones: hip–knee–ankle or shoulder–elbow–wrist. World positions, metres.
struct TwoBoneLimb {
  Vec3 root;
  Vec3 middle;
  Vec3 end;
};

/// Rotations of the limb's two bones, world space: new world rotation = turn · previous one.
struct TwoBoneSolution {
  Quat upper_turn = Quat::Identity();
  Quat lower_turn = Quat::Identity();
  Vec3 middle;  ///< resulting position of the middle joint
  Vec3 end;     ///< resulting position of the end: the target if it can be reached
};

/// Moves the limb's end to `target` with constant bone lengths. The plane of flexion rotates with
/// the line from root to end and is otherwise kept. `bend_hint` is the direction from that line in
/// which the middle joint should lie; it takes over smoothly as the limb comes within 10° of
/// straight, where the plane of flexion is ill-defined. A target out of reach is approached as far
/// as `max_extension` (share of the two bones' summed length) allows.
TwoBoneSolution solve_two_bone(const TwoBoneLimb& limb, const Vec3& target, const Vec3& bend_hint,
                               double max_extension = 0.9999);

}  // namespace mien::motion
