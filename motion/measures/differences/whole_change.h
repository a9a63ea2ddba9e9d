#pragma once

#include <string_view>

#include "motion/measures/differences/joint_difference.h"

namespace mien::motion {

/// A transformation of a motion as a whole.
enum class WholeChange {
  none,
  moved,          ///< rotated about the vertical and translated; poses are unchanged
  mirrored,       ///< mirrored, with left and right exchanged
  flipped,        ///< geometry mirrored without exchanging left and right
  renamed_sides,  ///< same trajectories, but with the names of left and right exchanged
  swapped_turns,  ///< rotations of left and right exchanged without mirroring
  scaled,         ///< uniformly scaled by a factor above 1.5 or below 1/1.5, as by different units
};

/// "none", "moved", …
std::string_view name_of(WholeChange change);

/// A transformation of the whole motion, reported if it explains nearly all of the difference:
/// `moved` and `scaled` if less than 1 % of the distance remains; `swapped_turns` if less than 15 %
/// of the angle remains; the others if less than 15 % remains of the distance after `moved` (a
/// larger share because bodies are not perfectly symmetric).
struct WholeBodyChange {
  WholeChange kind = WholeChange::none;
  double turn_radians = 0.0;  ///< about +Y, from `horizontal_fit` (similarity.h)
  Vec3 shift = Vec3::Zero();  ///< metres, applied after the rotation
  double scale = 1.0;  ///< scale factor if `scaled`: 10 if one metre before is ten metres now
  /// RMS distance of the joints without the transformation, metres; after `moved` for `mirrored`,
  /// `flipped` and `renamed_sides`; RMS angle, radians, for `swapped_turns`.
  double before = 0.0;
  double remaining = 0.0;  ///< what remains of `before` after the transformation, same unit
};

WholeBodyChange whole_change(const PairedMotions& pair, const Skeleton& before,
                             const Skeleton& now);

/// Difference in the placement of the body, measured in world space at its first shared joint with
/// more than one child (usually the pelvis). One value per frame.
struct RootDifference {
  int joint = 0;                        ///< index among the shared joints
  std::vector<double> path_m;           ///< horizontal distance
  std::vector<double> height_m;         ///< vertical distance, ≥ 0
  std::vector<double> heading_radians;  ///< rotation about the vertical
  std::vector<double> tilt_radians;     ///< remaining rotation
};

RootDifference root_difference(const PairedMotions& pair, const Skeleton& before);

}  // namespace mien::motion
