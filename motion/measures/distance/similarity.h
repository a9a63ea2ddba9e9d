#pragma once

#include <span>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A similarity transform (uniform scale, rotation, translation): p ↦ scale · rotation · p + shift.
struct Similarity {
  double scale = 1.0;
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& point) const { return scale * (rotation * point) + shift; }
};

/// The similarity that maps the points of `from` to those of `to` with the least sum of squared
/// distances (Procrustes alignment), never including a reflection (Umeyama 1991, eq. 40–42). If all
/// points of `from` coincide, the result is a translation only; if both sets are equal, it is
/// exactly the identity. Both must have the same number of points, at least one.
Similarity similarity_fit(std::span<const Vec3> from, std::span<const Vec3> to);

/// A rotation about the vertical and a translation, after reflection in the plane x = 0 if
/// `mirrored`. Without reflection it does not change the poses of a motion on a horizontal floor,
/// only their placement.
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
