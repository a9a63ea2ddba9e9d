#pragma once

#include "motion/skeleton/example.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// A recorded motion in the form compared by `mien motion compare`: one gait cycle if it contains
/// one, otherwise the whole motion. With `settle`, its planted feet are locked to the floor
/// (settled_feet.h), as in a blend: captured feet often float above the floor, which would dominate
/// the distance. The feet of a loop without cycle displacement, such as a walk in place, are not
/// locked. Throws Error if the motion is not human or has fewer than two frames.
Example compared_example(const Recording& recording, bool settle = true);

/// `compared_example` of a clip after the rounding caused by writing it to a BVH file and reading
/// it back.
Example compared_example_as_written(const Clip& clip, bool settle = true);

}  // namespace mien::motion
