#pragma once

#include <optional>

#include "motion/measures/distance/distance.h"

namespace mien::motion {

/// How differently two motions hold their fingers: the distance between corresponding fingertips,
/// each seen from its wrist, mean over ten fingertips and the times of `distance`. Metres; not part
/// of D. Lengths are not scaled. Empty if one of the motions has no fingers.
std::optional<double> hands_distance(const Example& target, const Example& created);

}  // namespace mien::motion
