#pragma once

#include <string_view>

#include "motion/measures/differences/joint_difference.h"

namespace mien::motion {

/// A transformation of a motion as a whole.
enum class WholeChange {
  none,
  moved,          ///< turned about the vertical and set elsewhere; poses are the same
  mirrored,       ///< mirrored, with left and right exchanged
  flipped,        ///< geometry mirrored without exchanging left and right
  renamed_sides,  ///< same trajectories, but the names of left and right are exchanged
  swapped_turns,  ///< rotations of left and right exchanged, not mirrored
  scaled,         ///< uniformly scaled, as by other units
};

/// "none", "moved", …
std::string_view name_of(WholeChange change);

/// A transformation of the whole motion, reported if it explains nearly all of the difference:
/// `moved` and `scaled` when less than 1 % of the distance is left, the others when less than 15 %
/// is (bodies are not quite symmetric) of what moving and turning the motion leaves.
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

/// Difference in the placement of the body: of its first joint with more than one child (the
/// pelvis), in the world. One value for each frame.
struct RootDifference {
  int joint = 0;                        ///< index among the shared joints
  std::vector<double> path_m;           ///< horizontal
  std::vector<double> height_m;         ///< vertical, positive
  std::vector<double> heading_radians;  ///< of its turn about the vertical
  std::vector<double> tilt_radians;     ///< the rest of its turn
};

RootDifference root_difference(const PairedMotions& pair, const Skeleton& before);

}  // namespace mien::motion
