#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Change of one plant of a foot.
struct ContactChange {
  enum class Kind { shifted, gone, appeared };
  Kind kind = Kind::shifted;
  double begin_seconds = 0.0;  ///< in the first motion; in the second if it appeared
  double end_seconds = 0.0;
  double begin_shift = 0.0;  ///< seconds later than in the first; only of `shifted`
  double end_shift = 0.0;
};

/// One foot's contacts with the floor in two motions.
struct FootDifference {
  int frames = 0;                      ///< of the first motion in which contact differs
  std::vector<ContactChange> changes;  ///< by time; unchanged plants are omitted
  /// Additional slide of the foot while it is planted in both motions: the largest change of the
  /// horizontal offset between the balls of both within a plant, metres. A constant offset is no
  /// slide.
  double slide_m = 0.0;
  double slide_seconds = 0.0;  ///< when it has slid so far
};

/// Contact differences of the left and the right foot. Both clips are of the canonical body.
/// Contacts are those of contact.h, each at its motion's frame rate.
std::array<FootDifference, 2> contact_differences(const Clip& before, const Clip& now);

}  // namespace mien::motion
