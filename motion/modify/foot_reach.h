#pragma once

#include <vector>

#include "motion/gait/foot_placement.h"

namespace mien::motion {

/// The clip with its root moved, horizontally and smoothly, to where the legs can reach the targets
/// of the feet: no hip is farther from its foot's target, horizontally, than 0.9 of the length of
/// the leg, so that the pelvis need not be lower than 0.4 of it. Unchanged where that is so
/// already, as in all motions but exaggerated ones. If the feet are too far apart for both, the
/// root is moved towards their middle.
Clip with_feet_in_reach(const Clip& clip, const std::vector<FootTrajectory>& stretches);

}  // namespace mien::motion
