#pragma once

#include <span>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A similarity transform (rotation, uniform scale, translation): p ↦ scale · rotation · p + shift.
struct Similarity {
  double scale = 1.0;
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& point) const { return scale * (rotation * point) + shift; }
};

/// The similarity that takes `from` to `to`, point by point, with the least sum of squared
/// distances: never a mirroring (Umeyama 1991, eq. 40–42). Points that all lie at one place are
/// only shifted; equal points give the identity exactly. Both have the same number of points, at
/// least one.
Similarity similarity_fit(std::span<const Vec3> from, std::span<const Vec3> to);

/// A rotation about the vertical and a translation, after mirroring at x = 0 if `mirrored`: it
/// leaves the poses of a motion on a horizontal floor unchanged.
struct HorizontalTransform {
  bool mirrored = false;
  double turn_radians = 0.0;  ///< about +Y
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& point) const;
};

/// The HorizontalTransform that maps `from` to `to` with the least sum of squared distances.
HorizontalTransform horizontal_fit(std::span<const Vec3> from, std::span<const Vec3> to,
                                   bool mirrored);

}  // namespace mien::motion
