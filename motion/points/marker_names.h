#pragma once

#include <span>
#include <string_view>

#include "motion/points/marker_sets.h"

namespace mien::motion {

/// A name in a set. "*" stands for the side: "L", "Left", "R" or "Right"; without it the point is
/// on the midline. Case and separators do not matter.
struct MarkerName {
  std::string_view pattern;
  Landmark landmark;
};

struct MarkerNames {
  std::string_view set;
  std::span<const MarkerName> names;
};

/// All sets that are recognised; of two that fit equally well the first counts.
std::span<const MarkerNames> known_marker_sets();

/// Abbreviations that laboratories use for further points in any set.
std::span<const MarkerName> marker_abbreviations();

}  // namespace mien::motion
