#pragma once

#include <optional>
#include <span>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// The half-space bounded by the plane through `point` with the unit normal `inward`, which points
/// into it.
struct HalfSpace {
  motion::Vec3 point = motion::Vec3::Zero();
  motion::Vec3 inward = motion::Vec3::UnitY();
};

/// A primitive of a signed distance field: a round cone or an ellipsoid, optionally clipped by a
/// plane.
///
/// All lengths in metres, world space.
struct SdfPrimitive {
  enum class Shape { round_cone, ellipsoid };
  Shape shape = Shape::ellipsoid;

  motion::Vec3 start = motion::Vec3::Zero();  ///< centre of the ellipsoid or of the first sphere
  motion::Vec3 end = motion::Vec3::Zero();    ///< centre of the second sphere; round cone only
  double start_radius = 0.0;
  double end_radius = 0.0;

  motion::Mat3 axes = motion::Mat3::Identity();  ///< columns: the ellipsoid's axes
  motion::Vec3 radii = motion::Vec3::Ones();     ///< the ellipsoid's semi-axes along `axes`

  double blend = 0.03;  ///< radius of the smooth union with the primitives before it, metres
  std::optional<HalfSpace> within;  ///< half-space to which the shape is clipped; none: not clipped
};

/// Signed distance to the surface, negative inside; for ellipsoids the first-order estimate of
/// Quilez ("Ellipsoid SDF"), exact at the surface, but never less than the distance to the sphere
/// that contains the ellipsoid.
double signed_distance(const SdfPrimitive& primitive, const motion::Vec3& point);

/// The polynomial smooth minimum (Quilez, "Smooth minimum"): min(a, b) where a and b differ by
/// `blend` or more; elsewhere smaller than that, by at most `blend` / 4 (at a = b).
double smooth_minimum(double a, double b, double blend);

/// Approximate signed distance to the smooth union of the primitives, in order. 1,000 m when there
/// are none.
double signed_distance(std::span<const SdfPrimitive> primitives, const motion::Vec3& point);

}  // namespace mien::scenes
