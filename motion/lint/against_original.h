#pragma once

#include <array>
#include <vector>

#include "motion/biomechanics/subject.h"

namespace mien::motion {

/// The ends of the limbs, by whose ways a motion is compared with its original: head, hands, feet.
inline constexpr std::array<int, 5> limb_ends = {Head, LeftWrist, RightWrist, LeftAnkle,
                                                 RightAnkle};

/// Way of a limb's end as seen from the part of the trunk that carries the limb (chest or pelvis),
/// in its frame, metres: what the limb itself does.
std::vector<Vec3> limb_way(const LintSubject& subject, int end);

/// `other`'s way at the moments that correspond to the frames of `subject`, linear between frames.
std::vector<Vec3> at_moments_of(const LintSubject& subject, const LintSubject& other,
                                const std::vector<Vec3>& way);

}  // namespace mien::motion
