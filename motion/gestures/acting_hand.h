#pragma once

#include <optional>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A gesture of one hand: a wave, a knock. The other hand rests.
struct Gesture {
  bool left = false;  ///< the hand that acts
  /// Its wrist frame by frame, metres, from where it hangs (straight below its shoulder, the arm
  /// stretched), in axes of the pelvis' heading: x to the left, y up, z forward.
  std::vector<Vec3> away;
  int first = 0,
      last = 0;  ///< frames in which it is raised: farther than half the largest distance
  Vec3 centre = Vec3::Zero();  ///< mean of `away` while raised
  /// Frames (fractional) in which it is fastest on the way to one end of a stroke, while it is held
  /// up (beyond 80 % of the largest distance): from one to the next it goes there and back.
  std::vector<double> strokes;
};

/// Whether the person walks or runs, rather than standing or shifting weight: at some time the root
/// moves at more than 0.25 m/s on average over two seconds (or over all of a shorter clip).
bool is_locomotion(const Clip& clip);

/// The gesture of a clip of the canonical body. Empty for a loop, for locomotion (arms that swing
/// far are not a gesture), if no wrist rises by 15 cm more than it hangs, and if both do so and the
/// wrist of one moves less than 1.5 times as far as that of the other.
std::optional<Gesture> acting_hand(const Clip& clip);

}  // namespace mien::motion
