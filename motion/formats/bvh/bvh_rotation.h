#pragma once

#include "motion/math/rotation.h"

namespace mien::motion {

// In the BVH files that mien writes, a rotation consists of angles about the Z, X and Y axes, in
// this order, in degrees.

/// The Euler angles of a rotation about the Z, X and Y axes, in this order, radians. Of all
/// equivalent triples, those nearest to the angles of the previous frame are returned, so that
/// curves are continuous across ±180°.
Vec3 bvh_angles(const Quat& rotation, const Vec3& previous);

/// `rotation` multiplied on the right by a rotation about a coordinate axis, as for each rotation
/// channel.
Quat turned(const Quat& rotation, Axis axis, double degrees);

}  // namespace mien::motion
