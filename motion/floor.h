#pragma once

#include <vector>

#include "motion/clip.h"

namespace mien::motion {

/// Height of the lowest point of either foot (ankle, toe joint, toe tip), frame by frame, metres.
std::vector<double> lowest_foot_heights(const Clip& clip);

/// Height of the floor under a clip: the level at which the lowest foot point rests, its third
/// percentile over the frames in which that point is slow (all frames when it never is).
double floor_height(const Clip& clip);

}  // namespace mien::motion
