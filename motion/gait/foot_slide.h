#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// How far a foot slides on the floor while it is planted: metres, horizontal, largest over the
/// plants. Of clips that do not loop.
///
/// Measured at the points of contact: the heel's edge, the ball (under the toe joint) and the tip
/// of the toes, each while it is within 5 mm of the foot's lowest point in the plant. Of several
/// points in contact the slowest counts: a foot that rolls on its heel's edge, lifts its heel over
/// its ball or pivots on it does not slide. `planted_drift` (foot_lock.h) follows a point of the
/// heel 2 cm above the sole, which a heel that rolls down moves by half a centimetre, and a ball
/// until it is 1 cm above the floor.
double planted_slide(const Clip& clip, const std::vector<FootPlant>& plants);

}  // namespace mien::motion
