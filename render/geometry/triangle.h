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

/// Eight vectors, one per lane.
struct PatchVectors {
  alignas(32) float x[patch_size];
  alignas(32) float y[patch_size];
  alignas(32) float z[patch_size];

  void set(std::size_t lane, const Vec3& vector) {
    x[lane] = vector.x();
    y[lane] = vector.y();
    z[lane] = vector.z();
  }
};

/// The corners of up to eight triangles. Unused lanes hold triangles without area.
struct PatchCorners {
  PatchVectors a;
  PatchVectors b;
  PatchVectors c;
};

/// The lines of the edges of up to eight triangles, from b to c, c to a and a to b.
struct PatchEdges {
  struct Edge {
    PatchVectors vector;
    PatchVectors moment;  ///< cross product of its start and end
  };
  Edge bc;
  Edge ca;
  Edge ab;
};

/// Up to eight triangles, prepared for intersection. No ray hits triangles without area.
struct TrianglePatch {
  PatchVectors a;
  PatchVectors normal;  ///< (b − a) × (c − a)
  PatchEdges edges;
};

/// Returns the triangles in patches of consecutive ones: triangle i is lane i mod 8 of patch i / 8.
std::vector<PatchCorners> corners_of(const std::vector<Triangle>& triangles);

TrianglePatch prepared_patch(const PatchCorners& corners);

/// Writes, for each triangle of the patch, the distance at which ray `lane` hits it; infinity where
/// the ray misses it, also if the ray's line crosses the triangle behind the origin. Returns the
/// least of these distances. Results are bit-identical on every machine.
///
/// The test is watertight: the side on which the line passes an edge is the sign of a product of
/// the Plücker coordinates of both (Shoemake 1998), which depends on nothing else. Reversing the
/// edge negates the product exactly. A line through an edge that two triangles share therefore hits
/// at least one of them.
float intersect_patch(const TrianglePatch& patch, const RayLanes& rays, unsigned lane,
                      float* distances);

/// As above, for a patch at a time from 0 (`from`) to 1 (`to`), moved in straight lines.
float intersect_moving_patch(const PatchCorners& from, const PatchCorners& to, float time,
                             const RayLanes& rays, unsigned lane, float* distances);

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
inline Barycentric barycentric(const Triangle& triangle, const Vec3& point) {
  const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Vec3 normal = ab.cross(ac);
  const float squared = normal.squaredNorm();
  if (!(squared > 0.0f)) return {0.0f, 0.0f};
  const Vec3 ap = point - triangle.a;
  return {ap.cross(ac).dot(normal) / squared, ab.cross(ap).dot(normal) / squared};
}

}  // namespace mien::render
