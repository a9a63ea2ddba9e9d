#pragma once

#include "motion/measures/distance/distance.h"

namespace mien::motion {

/// D over 22 points: the joints of eq. (8) and the tips of both hands (hand_tip.h), which gestures
/// move more than wrists. Otherwise as `distance`. Metres.
double distance_with_hand_tips(const Example& target, const Example& created,
                               Alignment alignment = Alignment::pelvis);

}  // namespace mien::motion
