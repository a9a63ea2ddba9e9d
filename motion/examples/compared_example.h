#pragma once

#include "motion/skeleton/example.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A recorded motion as `mien motion compare` compares it: one gait cycle if there is one, else the
/// whole motion. With `settle`, its planted feet are locked to the floor (settled_feet.h) like
/// those of a blend: captures often float above the floor, which would dominate the distance.
/// Throws Error when it is no human motion of at least two frames.
Example compared_example(const Recording& recording, bool settle = true);

/// compared_example of a clip, with the rounding of a BVH file that is written and read again.
Example compared_example_as_written(const Clip& clip, bool settle = true);

}  // namespace mien::motion
