#pragma once

#include "render/geometry/prepared_cone.h"
#include "render/math/vector.h"

namespace mien::render {

struct Triangle {
  Vec3 a;
  Vec3 b;
  Vec3 c;
};

/// Where each of `count` ≤ max_lanes lines crosses a triangle, as distances along the ray; infinity
/// when it misses. The same bits on every machine.
///
/// A line is on the inner side of an edge by the sign of a product that only the edge and the line
/// go into, and that turns round exactly when the edge does: of two triangles that share an edge, a
/// line through it meets at least one (Plücker coordinates; Shoemake 1998).
void intersect_triangle(const Triangle& triangle, const RayLanes& rays, unsigned count,
                        float* distance);

/// Barycentric weights of b and c at a point of the triangle's plane.
struct Barycentric {
  float b;
  float c;
};
Barycentric barycentric(const Triangle& triangle, const Vec3& point);

}  // namespace mien::render
