#pragma once

#include "render/geometry/prepared_cone.h"
#include "render/math/vector.h"

namespace mien::render {

struct Triangle {
  Vec3 a;
  Vec3 b;
  Vec3 c;
};

/// Writes the distance at which each of `count` ≤ max_lanes rays hits the triangle; infinity when
/// it misses, also if its line crosses the triangle behind the origin. Results are bit-identical on
/// every machine.
///
/// The test is watertight: the side on which the line passes an edge is the sign of a product that
/// depends on the line and this edge alone and changes sign exactly when the edge is reversed. A
/// line through an edge that two triangles share therefore hits at least one of them (Plücker
/// coordinates; Shoemake 1998).
void intersect_triangle(const Triangle& triangle, const RayLanes& rays, unsigned count,
                        float* distance);

/// Barycentric weights of b and c at a point of the triangle's plane.
struct Barycentric {
  float b;
  float c;
};
Barycentric barycentric(const Triangle& triangle, const Vec3& point);

}  // namespace mien::render
