#pragma once

#include <span>
#include <vector>

#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

/// Shares of a graph's versions that moods ask for at a moment, one a version, of sum 1: those of
/// the last change until then, or of the first; the first version alone without any change.
std::vector<double> shares_asked(std::span<const MoodFrom> moods, double seconds,
                                 std::size_t versions);

}  // namespace mien::motion
