#pragma once

#include "motion/math/rotation.h"

namespace mien::motion {

/// Rotations as BVH files hold them: angles about the Z, X and Y axis, in this order, degrees.

/// The angles, radians, of a joint that is written: of the two triples that make a rotation, and of
/// their whole turns, what lies nearest to the previous frame's, so that curves run on over ±180°.
Vec3 bvh_angles(const Quat& rotation, const Vec3& previous);

/// rotation · (turn about a coordinate axis), as each channel that is read turns its joint.
Quat turned(const Quat& rotation, Axis axis, double degrees);

}  // namespace mien::motion
