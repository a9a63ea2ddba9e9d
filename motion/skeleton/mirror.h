#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The pose mirrored in the plane x = 0, left and right exchanged. The result is exact on a
/// symmetric body.
Pose mirrored(const Pose& pose);

/// The mirrored clip, on the mirrored body.
Clip mirrored(const Clip& clip);

/// A rotation vector, and a position, mirrored in the plane x = 0.
inline Vec3 mirrored_turn(const Vec3& turn) { return {turn.x(), -turn.y(), -turn.z()}; }

inline Vec3 mirrored_place(const Vec3& place) { return {-place.x(), place.y(), place.z()}; }

}  // namespace mien::motion
