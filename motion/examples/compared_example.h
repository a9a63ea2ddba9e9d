#pragma once

#include "motion/skeleton/example.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A recorded motion as `mien motion compare` compares it: one gait cycle where there is one, else
/// all of the motion. With `settle`, its feet are settled where they stand in the world, as those
/// of a blend are: captures hang above the floor, and else their height would be most of the
/// distance. Throws Error when it is no human motion of at least two frames.
Example compared_example(const Recording& recording, bool settle = true);

/// Of a clip as if it had been written to a BVH file and read again.
Example compared_example_as_written(const Clip& clip, bool settle = true);

}  // namespace mien::motion
