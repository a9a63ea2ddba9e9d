#pragma once

#include "render/math/sampler.h"
#include "render/math/vector.h"

namespace mien::render {

// These functions use only arithmetic and square roots, no libm, so that results are bit-identical
// on every machine.

/// Arc sine for 0 … 1, radians, to 1e-7.
float arc_sine(float x);

/// A point of the unit disc, uniformly distributed by the concentric mapping (Shirley & Chiu 1997),
/// which maps concentric squares to concentric circles and keeps strata compact.
struct DiscPoint {
  float x;
  float y;
};
DiscPoint disc_point(Point2 u);

/// Unit vectors a and b such that a, b and the unit vector `normal` form a right-handed frame (Duff
/// et al. 2017).
struct Tangents {
  Vec3 a;
  Vec3 b;
};
Tangents tangents(const Vec3& normal);

/// Unit direction about `normal` with density cos θ / π.
Vec3 cosine_direction(const Vec3& normal, Point2 u);

/// Unit direction within a cone about `axis`, uniformly distributed: density 1 / (2π (1 − cos
/// half_angle)).
Vec3 cone_direction(const Vec3& axis, float cosine_of_half_angle, Point2 u);

}  // namespace mien::render
