#pragma once

#include <vector>

#include "motion/math/rotation.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The two direction vectors of a rotation (rotation.h) in a row: d1, then d2.
using Directions = Eigen::Matrix<double, 6, 1>;

Directions directions_of(const Quat& rotation);

/// Orthonormal again; what degenerate directions lack comes from `previous`.
Quat to_rotation(const Directions& directions, const Quat& previous);

/// The direction vectors of one joint, frame by frame.
std::vector<Directions> direction_curve(const Clip& clip, int joint);

/// Sets the rotations of one joint from a curve of direction vectors. The curve has as many
/// entries as the clip has frames.
void set_rotations(Clip& clip, int joint, const std::vector<Directions>& curve);

/// A curve between its samples, by Catmull–Rom splines: exact at the samples, no jump of speed.
/// A periodic curve is continued; another is clamped to its ends.
Directions value_at(const std::vector<Directions>& curve, double frame, bool periodic);

}  // namespace mien::motion
