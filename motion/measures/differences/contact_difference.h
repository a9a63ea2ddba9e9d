#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Change of one plant of a foot.
struct ContactChange {
  enum class Kind { shifted, gone, appeared };
  Kind kind = Kind::shifted;
  double begin_seconds = 0.0;  ///< in the first motion (in the second if the plant appeared)
  double end_seconds = 0.0;
  double begin_shift = 0.0;  ///< delay relative to the first motion, seconds; for `shifted` only
  double end_shift = 0.0;
};

/// One foot's contacts with the floor in two motions.
struct FootDifference {
  int frames = 0;  ///< number of frames of the first motion in which contact differs
  std::vector<ContactChange> changes;  ///< in order of time; unchanged plants are omitted
  /// Additional slide of the foot while it is planted in both motions: the largest change, within a
  /// plant, of the horizontal offset between the balls of the foot in the two motions, metres. A
  /// constant offset is not a slide.
  double slide_m = 0.0;
  double slide_seconds = 0.0;  ///< time of the largest slide
};

/// Contact differences of the left and the right foot. Both clips are of the canonical body; if one
/// has fewer than three frames, there are no differences. Contacts are detected as in contact.h.
std::array<FootDifference, 2> contact_differences(const Clip& before, const Clip& now);

}  // namespace mien::motion
