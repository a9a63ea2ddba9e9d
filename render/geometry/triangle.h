#pragma once

#include <cstddef>
#include <vector>

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
  struct Corners {
    alignas(32) float x[patch_size] = {};
    alignas(32) float y[patch_size] = {};
    alignas(32) float z[patch_size] = {};
  };
  Corners a;
  Corners b;
  Corners c;
};

/// Returns the triangles in patches of consecutive ones: triangle i is lane i mod 8 of patch i / 8.
std::vector<TrianglePatch> patches_of(const std::vector<Triangle>& triangles);

/// Returns the patch between two positions, moved there from `from` (time 0) to `to` (time 1) in
/// straight lines.
TrianglePatch patch_between(const TrianglePatch& from, const TrianglePatch& to, float time);

/// Writes, for each triangle of the patch, the distance at which the ray hits it; infinity where it
/// misses, also if its line crosses the triangle behind the origin. Results are bit-identical on
/// every machine.
///
/// The test is watertight: the side on which the line passes an edge is the sign of a product that
/// depends on the line and this edge alone and changes sign exactly when the edge is reversed. A
/// line through an edge that two triangles share therefore hits at least one of them (Plücker
/// coordinates; Shoemake 1998).
void intersect_patch(const TrianglePatch& patch, const Vec3& origin, const Vec3& direction,
                     float* distance);

/// Barycentric weights of b and c at a point of the triangle's plane.
struct Barycentric {
  float b;
  float c;
};
Barycentric barycentric(const Triangle& triangle, const Vec3& point);

}  // namespace mien::render
