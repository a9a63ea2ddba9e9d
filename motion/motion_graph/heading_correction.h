#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/graph_walk.h"

namespace mien::motion {

/// A requested heading of a walk at a time, and the script segment that requests it.
struct HeadingGoal {
  double seconds = 0.0;
  double radians = 0.0;
  double over_seconds = 0.5;  ///< duration before it over which the walk's heading is averaged
  std::size_t segment = 0;
};

/// Heading correction of each frame of a walk, and the remaining error at each goal, radians.
struct HeadingCorrection {
  std::vector<double> added;
  std::vector<double> missing;
};

/// Spreads the heading error at each goal over the interval since the previous goal, without its
/// last `over_seconds` (but over at least half of the interval): at most 25°, and at most 12°/s on
/// average, which is not visible with locked feet. Goals are in ascending order of time.
HeadingCorrection correct_headings(const WalkHeadings& headings,
                                   std::span<const HeadingGoal> goals);

}  // namespace mien::motion
