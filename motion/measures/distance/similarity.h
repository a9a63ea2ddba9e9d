#pragma once

#include <span>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A turn, an even scaling and a shift: p ↦ scale · rotation · p + shift.
struct Similarity {
  double scale = 1.0;
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& point) const { return scale * (rotation * point) + shift; }
};

/// The similarity that takes `from` to `to`, point by point, with the least sum of squared
/// distances: never a mirroring (Umeyama 1991, eq. 40–42). Points that all lie at one place are
/// only shifted; equal points give the identity exactly. As many of both, one at least.
Similarity similarity_fit(std::span<const Vec3> from, std::span<const Vec3> to);

/// A turn about the vertical and a shift, after a mirroring at x = 0 if `mirrored`: what can be
/// done to a motion on a level floor without changing its poses.
struct LevelMove {
  bool mirrored = false;
  double turn_radians = 0.0;  ///< about +Y
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& point) const;
};

/// The level move that takes `from` to `to` with the least sum of squared distances.
LevelMove level_fit(std::span<const Vec3> from, std::span<const Vec3> to, bool mirrored);

}  // namespace mien::motion
