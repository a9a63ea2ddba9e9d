#pragma once

#include "motion/math/rotation.h"

namespace mien::motion {

/// Rotations as BVH files hold them: angles about the Z, X and Y axis, in this order, degrees.

/// Euler angles, radians, of a rotation: of the two equivalent triples and their full turns those
/// nearest to the previous frame's, so that curves are continuous across ±180°.
Vec3 bvh_angles(const Quat& rotation, const Vec3& previous);

/// rotation · (turn about a coordinate axis), as each channel that is read turns its joint.
Quat turned(const Quat& rotation, Axis axis, double degrees);

}  // namespace mien::motion
