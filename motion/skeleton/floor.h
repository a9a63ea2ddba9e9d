#pragma once

#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Height of the lowest point of both soles (sole.h), frame by frame, metres.
std::vector<double> lowest_sole_heights(const Clip& clip);

/// Height of the floor under a clip: the level at which the lowest sole point rests, its third
/// percentile over the frames in which that point is slow (all frames when it never is).
double floor_height(const Clip& clip);

/// The rotation that levels a floor which slopes in the recording, as happens when the capture
/// volume was not levelled: identity unless both feet rest along one slope of 1.5–6°, over at least
/// 0.8 m and five separate plants, and a level floor would leave much larger errors.
Quat floor_levelling(const Clip& clip);

}  // namespace mien::motion
