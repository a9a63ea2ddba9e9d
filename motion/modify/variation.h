#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// A smooth curve that wanders at random within about ±1, one value a frame: splines through random
/// numbers some `knot_seconds` apart. A pure function of seed and name, whatever else is drawn. The
/// curve of a loop goes on over its seam and has at least three knots.
std::vector<double> smooth_random_curve(std::uint64_t seed, std::string_view name, int frame_count,
                                        double frames_per_second, bool loops,
                                        double knot_seconds = 0.7);

/// The clip with the path lengths and the timing of its limbs wandering at random, as nervous
/// people move: by up to ±60 % of what is quicker than 1 Hz and by up to ±0.08 s at `variation`
/// = 1. Each limb wanders by itself.
Clip with_variation(const Clip& clip, double variation, const Limbs& limbs, std::uint64_t seed);

}  // namespace mien::motion
