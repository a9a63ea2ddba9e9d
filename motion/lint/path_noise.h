#pragma once

#include <vector>

#include "motion/biomechanics/lint_motion.h"

namespace mien::motion {

/// Random noise of the path of a limb's end relative to the pelvis around each frame: standard
/// deviation of each coordinate, metres of a stature of 1.75 m, in windows of 0.75 s (at least 15
/// frames), by the median length of third differences, so that single leaps do not count. 0 unless
/// consecutive differences oppose each other, as those of noise do and those of movement do not
/// (below 20 frames per second, those of smooth movement do as well).
std::vector<double> path_noise(const LintMotion& motion, int end);

/// The same of any movement: the noise that would make the path as rough as it is.
std::vector<double> path_roughness(const LintMotion& motion, int end);

}  // namespace mien::motion
