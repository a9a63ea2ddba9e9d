#pragma once

#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/gait/foot_plant.h"

namespace mien::motion {

/// Where a planted foot has slid to in each frame of a plant but those of its first and last
/// 0.05 s, in which a foot comes down and leaves; from zero, level, metres: what the part of the
/// sole moves that is lowest.
std::vector<Vec3> planted_track(const LintSubject& subject, const FootPlant& plant);

/// How far, metres, a planted foot slides over the floor between the two most distant moments of
/// a plant, whatever it rolls meanwhile: what the part of the sole moves that is lowest. The first
/// and last 0.05 s of the plant, in which a foot comes down and leaves, do not count.
double planted_slip(const LintSubject& subject, const FootPlant& plant);

}  // namespace mien::motion
