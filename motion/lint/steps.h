#pragma once

#include <vector>

#include "motion/biomechanics/lint_motion.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

// Changes from one frame to the next, called steps; step i leads from frame i to frame i + 1.

/// Distance of each step from the mean of the steps before and after it (at the ends, from the only
/// one), but at most its own length: the neighbours of a long step differ from theirs too.
std::vector<double> excesses(const std::vector<Vec3>& steps);

/// Mean length of the steps before and after each.
std::vector<double> paces(const std::vector<Vec3>& steps);

/// Values of steps as values of the frames to which they lead; `no_value` for the first frame and
/// for steps over the seam of a loop.
std::vector<double> without_seams(const LintMotion& motion, const std::vector<double>& steps);

/// The levels for steps at a frame rate, Hz: multiplied by 30 Hz / rate below 30 Hz, where smooth
/// movement too changes more from step to step.
Levels at_rate(const Levels& levels, double rate);

}  // namespace mien::motion
