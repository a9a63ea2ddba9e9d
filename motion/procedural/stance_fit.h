#pragma once

#include <array>

#include "motion/procedural/leg_cycle.h"

namespace mien::motion {

/// Places the pelvis over the feet: as high as it can walk without either knee being straighter in
/// stance than the style's `stance_knee_deg`, and as far before or behind the feet as lets it be
/// highest. (People keep their legs about as straight as the step allows: it costs least.)
///
/// Sets `pelvis.mean_height_m` and `ahead_m` of both legs. Throws mien::Error when the steps are
/// too long for the legs.
void fit_stance(std::array<LegCycle, 2>& legs);

}  // namespace mien::motion
