#pragma once

#include <vector>

#include "motion/modify/modification.h"

namespace mien::motion {

/// The clip with its feet standing again where those of `original` stood: by the hip shift alone
/// (hip_shift.h, exact), or by a smooth hip shift, then every plant locked in its place
/// (foot_lock.h: constraint places, two-bone legs, smooth blends, the pelvis sinking where a leg
/// would stretch), then swinging toes lifted that would scrape the floor. Both clips travel and
/// have the same frames; `plants` are the original's.
Clip with_repaired_feet(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants, FootRepair repair);

/// The clip with swinging feet raised, smoothly, as far as they are lower than in `original` and
/// lower than 15 mm above the floor. Plants stay as they are.
Clip with_toe_clearance(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants);

}  // namespace mien::motion
