#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/gait/foot_plant.h"

namespace mien::motion {

/// How far, metres, a planted foot slides over the floor between the two most distant moments of
/// a plant, whatever it rolls meanwhile: what the part of the sole moves that is lowest. The first
/// and last 0.05 s of the plant, in which a foot comes down and leaves, do not count.
double planted_slip(const LintSubject& subject, const FootPlant& plant);

}  // namespace mien::motion
