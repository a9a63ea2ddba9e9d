#pragma once

#include <array>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How one stand of a foot on the floor differs.
struct ContactChange {
  enum class Kind { shifted, gone, appeared };
  Kind kind = Kind::shifted;
  double begin_seconds = 0.0;  ///< in the first motion; of one that appeared, in the second
  double end_seconds = 0.0;
  double begin_shift = 0.0;  ///< seconds later than in the first; only of `shifted`
  double end_shift = 0.0;
};

/// One foot's contacts with the floor in two motions.
struct FootDifference {
  int frames = 0;  ///< of the first motion, in which one stands and the other does not
  std::vector<ContactChange> changes;  ///< by time; none for stands that are the same
  /// How far the foot slides against what it did while it stands in both: the most that the way
  /// from the ball of one to the ball of the other changes within a stand, horizontally, metres. A
  /// foot that stands elsewhere all the while does not slide.
  double slide_m = 0.0;
  double slide_seconds = 0.0;  ///< when it has slid so far
};

/// Left, right. Both clips are of the canonical body. Contacts are those of contact.h, each at its
/// motion's own frame rate.
std::array<FootDifference, 2> contact_differences(const Clip& before, const Clip& now);

}  // namespace mien::motion
