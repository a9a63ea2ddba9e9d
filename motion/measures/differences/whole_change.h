#pragma once

#include <string_view>

#include "motion/measures/differences/joint_difference.h"

namespace mien::motion {

/// What was done to a motion as a whole, if something was.
enum class WholeChange {
  none,
  moved,          ///< turned about the vertical and set elsewhere; poses are the same
  mirrored,       ///< as a mirror shows it: left and right do each other's part
  flipped,        ///< geometry mirrored, but left joints are left still: a body inside out
  renamed_sides,  ///< where joints go is the same, but left and right have each other's names
  swapped_turns,  ///< left and right have each other's rotations, not mirrored
  scaled,         ///< all places are so many times as far from the origin: other units
};

/// "none", "moved", …
std::string_view name_of(WholeChange change);

/// A change of the whole motion, told when it explains nearly all: `moved` and `scaled` when less
/// than 1 % of the distance is left, the others when less than 15 % is (bodies are not quite
/// symmetric) of what moving and turning the motion leaves.
struct WholeBodyChange {
  WholeChange kind = WholeChange::none;
  double turn_radians = 0.0;  ///< about +Y, as the level fit has it (similarity.h)
  Vec3 shift = Vec3::Zero();  ///< metres, after the turn
  double scale = 1.0;         ///< of `scaled`: 10 where a metre before is ten metres now
  double before = 0.0;        ///< RMS distance of the joints without it, metres
  double left = 0.0;          ///< … with it. Of `swapped_turns` both are angles, radians
};

WholeBodyChange whole_change(const PairedMotions& pair, const Skeleton& before,
                             const Skeleton& now);

/// How the body as a whole is placed otherwise: the first joint that carries more than one other
/// (the pelvis), in the world. Values a moment.
struct RootDifference {
  int joint = 0;                        ///< index among the shared joints
  std::vector<double> path_m;           ///< horizontal
  std::vector<double> height_m;         ///< vertical, positive
  std::vector<double> heading_radians;  ///< of its turn about the vertical
  std::vector<double> tilt_radians;     ///< the rest of its turn
};

RootDifference root_difference(const PairedMotions& pair, const Skeleton& before);

}  // namespace mien::motion
