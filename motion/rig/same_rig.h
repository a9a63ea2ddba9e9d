#pragma once

#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Whether two skeletons have the same joint names, parents and offsets.
bool same_rig(const Skeleton& a, const Skeleton& b);

}  // namespace mien::motion
