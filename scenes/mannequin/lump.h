#pragma once

#include <optional>
#include <span>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// Half of space: what lies on the side of `point` that the unit vector `inward` points to.
struct HalfSpace {
  motion::Vec3 point = motion::Vec3::Zero();
  motion::Vec3 inward = motion::Vec3::UnitY();
};

/// A piece of flesh: a round cone or an ellipsoid, perhaps cut flat on one side.
///
/// All lengths in metres, world space.
struct Lump {
  enum class Shape { round_cone, ellipsoid };
  Shape shape = Shape::ellipsoid;

  motion::Vec3 start = motion::Vec3::Zero();  ///< centre of the ellipsoid or of the first ball
  motion::Vec3 end = motion::Vec3::Zero();    ///< of the second ball; not used by the ellipsoid
  double start_radius = 0.0;
  double end_radius = 0.0;

  motion::Mat3 axes = motion::Mat3::Identity();  ///< columns: the ellipsoid's axes
  motion::Vec3 radii = motion::Vec3::Ones();     ///< along them

  double blend = 0.03;  ///< how far it reaches to flow into what is there before it
  std::optional<HalfSpace> within;
};

/// Signed distance to the surface, negative inside; for ellipsoids the first-order estimate of
/// Quilez ("Ellipsoid SDF"), exact at the surface, but never less than the distance to the ball
/// that holds the ellipsoid.
double signed_distance(const Lump& lump, const motion::Vec3& point);

/// The polynomial smooth minimum (Quilez, "Smooth minimum"): min(a, b) where they differ by `blend`
/// or more, up to a quarter of `blend` less where they are equal.
double smooth_minimum(double a, double b, double blend);

/// Signed distance, nearly, to the lumps flowing into each other one after the other. Far away when
/// there are none.
double signed_distance(std::span<const Lump> lumps, const motion::Vec3& point);

}  // namespace mien::scenes
