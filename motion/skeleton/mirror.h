#pragma once

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The pose as a mirror in the plane x = 0 shows it: left and right exchanged. A mirrored pose is
/// exact on a symmetric body.
Pose mirrored(const Pose& pose);

/// The clip as the mirror shows it, on the mirrored body.
Clip mirrored(const Clip& clip);

/// A rotation vector as the mirror shows it.
inline Vec3 mirrored_turn(const Vec3& turn) { return {turn.x(), -turn.y(), -turn.z()}; }

inline Vec3 mirrored_place(const Vec3& place) { return {-place.x(), place.y(), place.z()}; }

}  // namespace mien::motion
