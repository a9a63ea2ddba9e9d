#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// The clip with its feet locked (foot_lock.h) until they drift by less than 0.5 mm, or until the
/// drift no longer falls, so that a capture's foot skate is not carried into its modification.
Clip with_still_feet(const Clip& original, const std::vector<FootPlant>& plants);

/// The clip with the plants of `still`, the original with still feet: after a
/// smooth hip shift (hip_shift.h), each rolls from heel to ball as it did, moved over the floor and
/// turned about the vertical to where the change has brought it, and the legs bend for it
/// (foot_placement.h). Then swinging toes are lifted that would scrape the floor. Both clips travel
/// and have the same frames.
Clip with_plants_carried_over(const Clip& clip, const Clip& still,
                              const std::vector<FootPlant>& plants);

/// The clip with its foot plants restored from `original`: by the hip shift alone (exact), or by
/// carrying the plants over. Both clips travel and have the same frames; `plants` are the
/// original's.
Clip with_repaired_feet(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants, FootRepair repair);

/// The clip with its feet raised, smoothly, where they sink by more than 5 mm deeper into the floor
/// than in the original: a foot that rolls off over the tip of its toes is put through the floor by
/// a lock that holds its ball down.
Clip with_feet_above_floor(const Clip& clip, const Clip& original);

/// The clip with swinging feet raised, smoothly, as far as they are lower than in `original` and
/// lower than 15 mm above the floor. Plants stay as they are.
Clip with_toe_clearance(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants);

}  // namespace mien::motion
