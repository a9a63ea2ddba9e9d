#pragma once

#include <vector>

#include "motion/fitting/fit_quality.h"
#include "motion/lint/finding.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Finds a body that is far from the points it was fitted to (the check `fit-residual`): more than
/// `far_from_points_mm` (root mean square over all points and frames) is a warning, more than twice
/// as much an error. Also finds each point that is further away, as a warning: it may be
/// mislabelled, or have moved on the skin. `joint` is then its name.
///
/// `clip` is the fitted motion, or a part of it at any frame rate; its first frame is
/// `start_seconds` after that of the fitted motion. The frames of a point are those from the first
/// to the last in which it is that far away.
std::vector<Finding> find_fit_residuals(const FitQuality& fit, const Clip& clip,
                                        double start_seconds = 0.0);

}  // namespace mien::motion
