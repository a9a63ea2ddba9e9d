#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/graph_walk.h"

namespace mien::motion {

/// Where a walk is to face at a moment, and which segment of its script says so.
struct HeadingWish {
  double seconds = 0.0;
  double radians = 0.0;
  double over_seconds = 0.5;  ///< before that moment, over which its heading is averaged
  std::size_t segment = 0;
};

/// Headings added to the frames of a walk so that it faces where it is to, and what is still
/// missing at each wish, radians.
struct SpreadHeading {
  std::vector<double> added;
  std::vector<double> missing;
};

/// Spreads what the headings are off by at each wish, by time ascending, over the way from the wish
/// before: no more than 25°, nor faster than 12°/s on the average, which feet that are locked
/// follow without being seen to.
SpreadHeading spread_heading(const WalkHeadings& headings, std::span<const HeadingWish> wishes);

}  // namespace mien::motion
