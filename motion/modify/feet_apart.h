#pragma once

#include <optional>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// How far apart sideways the feet are put down, metres, the least of all steps: of each the
/// distance of its ankle from the line between the places where the other foot stands before and
/// after it; negative when the foot crosses that line. Of somebody who stands the distance of both
/// ankles across the way he faces. Nothing of a motion with neither. Ankles are taken at their mean
/// place in a plant.
std::optional<double> least_step_width(const Clip& clip, const std::vector<FootPlant>& plants);

/// Width of a foot, metres: 0.09 at a stature of 1.75 m, as the lint has it (support.h).
double foot_width(const Skeleton& body);

/// Whether a posture of the modification may bring the feet closer together: thighs that are turned
/// inwards, or a captured pose.
bool may_bring_feet_together(const Modification& modification);

/// The modification with that part of its posture at a share from 0 to 1.
Modification with_feet_together(const Modification& modification, double share);

}  // namespace mien::motion
