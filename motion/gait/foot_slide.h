#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The horizontal distance by which a foot slides on the floor while planted, metres; maximum over
/// all plants. In a looping clip, plants may continue in the next cycle.
///
/// Slip is measured at the points of contact: the edge of the heel, the ball (under the toe joint)
/// and the tip of the toes, each while it is within 5 mm of the lowest point of the foot during the
/// plant. If several points are in contact, the slowest one counts, so a foot that rolls over the
/// edge of its heel, or lifts its heel or pivots on its ball, does not slide.
///
/// `planted_drift` (foot_lock.h) measures two points 2 cm above the sole: one of the heel, which
/// moves by half a centimetre when the heel rolls down, and one of the ball, until it has risen by
/// 1 cm.
double planted_slide(const Clip& clip, const std::vector<FootPlant>& plants);

}  // namespace mien::motion
