#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// A smooth random curve within about ±1, one value for each frame: a spline through random numbers
/// about `knot_seconds` apart. A pure function of seed and name. The curve of a loop is periodic
/// and has at least three knots.
std::vector<double> smooth_random_curve(std::uint64_t seed, std::string_view name, int frame_count,
                                        double frames_per_second, bool loops,
                                        double knot_seconds = 0.7);

/// The clip with random, smooth variations of the path lengths and the timing of its limbs, as in
/// nervous movement: by up to ±60 % of what is quicker than 1 Hz and by up to ±0.08 s at
/// `variation` = 1. Limbs vary independently.
Clip with_variation(const Clip& clip, double variation, const Limbs& limbs, std::uint64_t seed);

}  // namespace mien::motion
