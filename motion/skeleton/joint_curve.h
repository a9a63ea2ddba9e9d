#pragma once

#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The two direction vectors of a rotation (rotation.h) as one vector: d1, then d2.
using Directions = Eigen::Matrix<double, 6, 1>;

Directions directions_of(const Quat& rotation);

/// The rotation of direction vectors, made orthonormal again. Where they are degenerate, `previous`
/// supplies the missing direction.
Quat to_rotation(const Directions& directions, const Quat& previous);

/// The direction vectors of one joint, frame by frame.
std::vector<Directions> direction_curve(const Clip& clip, int joint);

/// Sets the rotations of one joint from a curve of direction vectors. The curve has as many
/// entries as the clip has frames.
void set_rotations(Clip& clip, int joint, const std::vector<Directions>& curve);

/// The value of a curve at a fractional frame, by a Catmull–Rom spline: exact at the frames, with a
/// continuous derivative. A periodic curve is continued; a non-periodic one is clamped to its ends.
Directions value_at(const std::vector<Directions>& curve, double frame, bool periodic);

}  // namespace mien::motion
