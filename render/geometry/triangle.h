#pragma once

#include <cstddef>
#include <vector>

#include "render/geometry/prepared_cone.h"
#include "render/math/vector.h"

namespace mien::render {

struct Triangle {
  Vec3 a;
  Vec3 b;
  Vec3 c;
};

/// Number of triangles that are intersected together.
inline constexpr std::size_t patch_size = 8;

/// Up to eight triangles, one per lane. Unused lanes hold triangles without area, which no ray
/// hits.
struct TrianglePatch {
  struct Vectors {
    alignas(32) float x[patch_size];
    alignas(32) float y[patch_size];
    alignas(32) float z[patch_size];

    void set(std::size_t lane, const Vec3& vector) {
      x[lane] = vector.x();
      y[lane] = vector.y();
      z[lane] = vector.z();
    }
    Vec3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  };
  Vectors a;
  Vectors b;
  Vectors c;
  Vectors normal;  ///< (b − a) × (c − a)

  void set(std::size_t lane, const Triangle& triangle);
  Triangle at(std::size_t lane) const { return {a.at(lane), b.at(lane), c.at(lane)}; }
};

/// Returns the triangles in patches of consecutive ones: triangle i is lane i mod 8 of patch i / 8.
std::vector<TrianglePatch> patches_of(const std::vector<Triangle>& triangles);

/// Returns the patch at a time from 0 (`from`) to 1 (`to`), moved in straight lines.
TrianglePatch patch_between(const TrianglePatch& from, const TrianglePatch& to, float time);

/// Writes, for each triangle of the patch, the distance at which ray `lane` hits it; infinity where
/// the ray misses it, also if the ray's line crosses the triangle behind the origin. Returns the
/// least of these distances. Results are bit-identical on every machine.
///
/// The test is watertight: the side on which the line passes an edge is the sign of a product that
/// depends only on the line and this edge. Reversing the edge negates the product exactly. A line
/// through an edge that two triangles share therefore hits at least one of them (Plücker
/// coordinates; Shoemake 1998).
float intersect_patch(const TrianglePatch& patch, const RayLanes& rays, unsigned lane,
                      float* distances);

/// Sets the reach of a ray to −infinity if the ray hits a triangle of the patch at a distance below
/// its reach. There are `count` rays; those with valid = 0 are skipped. The test is that of
/// intersect_patch.
void occlude_by_patch(const TrianglePatch& patch, const RayLanes& rays, const int* valid,
                      unsigned count, float* reach);

/// Barycentric weights of b and c at a point of the triangle's plane.
struct Barycentric {
  float b;
  float c;
};
Barycentric barycentric(const Triangle& triangle, const Vec3& point);

}  // namespace mien::render
