#pragma once

#include <optional>
#include <span>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// Least step width of a motion, metres: the lateral distance of an ankle from the line between the
/// other foot's previous and next plant; negative if the foot crosses that line. If the motion has
/// no steps, the lateral distance of the ankles while both feet stand; empty if they never do.
/// Ankle positions are means over a plant.
std::optional<double> least_step_width(const Clip& clip, std::span<const FootPlant> plants);

/// As least_step_width, the mean over all steps or stances.
std::optional<double> mean_step_width(const Clip& clip, std::span<const FootPlant> plants);

/// Width of a foot, metres: 0.09 at a stature of 1.75 m, the same as in the lint (support.h).
double foot_width(const Skeleton& body);

/// Whether the modification's posture may bring the feet closer together: adducted hips, or a
/// captured pose.
bool may_bring_feet_together(const Modification& modification);

/// The modification with its adduction of the hips, and the hip rotations of its captured pose,
/// scaled by a share from 0 (removed) to 1 (unchanged).
Modification with_feet_together(const Modification& modification, double share);

}  // namespace mien::motion
