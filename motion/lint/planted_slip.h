#pragma once

#include <vector>

#include "motion/biomechanics/lint_motion.h"
#include "motion/gait/foot_plant.h"

namespace mien::motion {

/// Accumulated horizontal slip of a planted foot, metres, in each frame of a plant except its first
/// and last 0.05 s, in which the foot lands and lifts. Begins at zero; measured at the lower of
/// heel and ball or, of a flat sole, at the one that moves less.
std::vector<Vec3> planted_track(const LintMotion& motion, const FootPlant& plant);

/// Largest slip of a planted foot between any two frames of a plant, metres, excluding rolling: the
/// extent of `planted_track`.
double planted_slip(const LintMotion& motion, const FootPlant& plant);

}  // namespace mien::motion
