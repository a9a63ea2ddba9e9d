#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// A smooth random curve within about ±1, one value per frame: a spline through random values about
/// `knot_seconds` apart. The n-th random value depends on seed and name only. The curve of a loop
/// is periodic and has at least three knots.
std::vector<double> smooth_random_curve(std::uint64_t seed, std::string_view name, int frame_count,
                                        double frames_per_second, bool loops,
                                        double knot_seconds = 0.7);

/// The clip with random, smooth variations of the path lengths and the timing of the given limbs,
/// as in nervous movement. At `variation` = 1, the amplitude of movement from 1 to 12.5 Hz changes
/// by up to ±60 %, and its timing by up to ±0.08 s. Limbs vary independently.
Clip with_variation(const Clip& clip, double variation, const Limbs& limbs, std::uint64_t seed);

}  // namespace mien::motion
