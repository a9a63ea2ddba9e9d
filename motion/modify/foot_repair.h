#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// The clip with its feet locked (foot_lock.h) repeatedly, at most six times, until they drift by
/// less than 0.5 mm. The result with the least drift is returned. A capture's foot skate is thus
/// not carried into its modification.
Clip with_still_feet(const Clip& original, const std::vector<FootPlant>& plants);

/// The clip with the foot plants of `still` (the original with locked feet). After a smooth hip
/// shift (hip_shift.h), each planted foot rolls from heel to ball as in `still`, translated over
/// the floor and rotated about the vertical to its position after the modification; the legs follow
/// by inverse kinematics (foot_placement.h). Toes that would scrape the floor in the swing are then
/// lifted. Neither clip walks in place; both have the same number of frames and frame rate.
Clip with_plants_carried_over(const Clip& clip, const Clip& still,
                              const std::vector<FootPlant>& plants);

/// The clip with its foot plants restored from `original`: by the exact hip shift alone, by
/// carrying the plants over, or not at all. Neither clip walks in place; both have the same number
/// of frames and frame rate; `plants` are the original's.
Clip with_repaired_feet(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants, FootRepair repair);

/// The clip with its feet raised, smoothly, where they penetrate the floor by over 5 mm more than
/// in the original: a lock that holds the ball of the foot down pushes the toes through the floor
/// at toe off, when the foot pivots about their tip.
Clip with_feet_above_floor(const Clip& clip, const Clip& original);

/// The clip with swinging feet raised, smoothly, to their height in `original`, but at least to the
/// floor and at most to 15 mm. Higher feet and plants are unchanged.
Clip with_toe_clearance(const Clip& clip, const Clip& original,
                        const std::vector<FootPlant>& plants);

}  // namespace mien::motion
