#pragma once

#include "motion/math/geometry.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Whether a rig with this up axis is the canonical body: as mien writes it, with its limbs, and
/// fingers if it has any, at rest in their directions and the toes straight ahead. Another rig of
/// these names has other directions.
bool is_canonical_rig(const Skeleton& rig, const Vec3& up);

/// Gives the hands of `body` the tips of the rig's, of a canonical rig with fingers: otherwise
/// hands would end where bent fingers do.
void keep_own_tips(const Skeleton& rig, Skeleton& body);

}  // namespace mien::motion
