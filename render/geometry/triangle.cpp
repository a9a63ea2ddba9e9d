#include "render/geometry/triangle.h"

#include <algorithm>

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {

namespace {

/// Where a ray crosses the planes of the triangles, as the distance times the cosine between ray
/// and normal, and this cosine; whether within the triangle.
struct Crossings {
  alignas(32) float scaled[patch_size];
  alignas(32) float facing[patch_size];
  alignas(32) int inside[patch_size];
};

[[gnu::always_inline]] inline int cross(const TrianglePatch& patch, const RayLanes& rays,
                                        unsigned lane, Crossings& found) {
  const float dx = rays.direction_x[lane], dy = rays.direction_y[lane];
  const float dz = rays.direction_z[lane];
  const float ox = rays.origin_x[lane], oy = rays.origin_y[lane], oz = rays.origin_z[lane];
  int any = 0;
#pragma omp simd reduction(| : any)
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float nx = patch.normal.x[i], ny = patch.normal.y[i], nz = patch.normal.z[i];
    const float pax = patch.a.x[i] - ox, pay = patch.a.y[i] - oy, paz = patch.a.z[i] - oz;
    const float pbx = patch.b.x[i] - ox, pby = patch.b.y[i] - oy, pbz = patch.b.z[i] - oz;
    const float pcx = patch.c.x[i] - ox, pcy = patch.c.y[i] - oy, pcz = patch.c.z[i] - oz;
    // Edge p → q: (q − p) × (q + p) · d.
    const auto side = [&](float px, float py, float pz, float qx, float qy, float qz) {
      const float ex = qx - px, ey = qy - py, ez = qz - pz;
      const float sx = qx + px, sy = qy + py, sz = qz + pz;
      return (ey * sz - ez * sy) * dx + (ez * sx - ex * sz) * dy + (ex * sy - ey * sx) * dz;
    };
    const float u = side(pbx, pby, pbz, pcx, pcy, pcz);
    const float v = side(pcx, pcy, pcz, pax, pay, paz);
    const float w = side(pax, pay, paz, pbx, pby, pbz);
    found.scaled[i] = nx * pax + ny * pay + nz * paz;
    found.facing[i] = nx * dx + ny * dy + nz * dz;
    found.inside[i] =
        (((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f))) &
        (found.facing[i] != 0.0f);
    any |= found.inside[i];
  }
  return any;
}

}  // namespace

void TrianglePatch::set(std::size_t lane, const Triangle& triangle) {
  a.set(lane, triangle.a);
  b.set(lane, triangle.b);
  c.set(lane, triangle.c);
  normal.set(lane, (triangle.b - triangle.a).cross(triangle.c - triangle.a));
}

std::vector<TrianglePatch> patches_of(const std::vector<Triangle>& triangles) {
  std::vector<TrianglePatch> patches((triangles.size() + patch_size - 1) / patch_size,
                                     TrianglePatch{});
  for (std::size_t i = 0; i < triangles.size(); ++i)
    patches[i / patch_size].set(i % patch_size, triangles[i]);
  return patches;
}

MIEN_FOR_AVX2_TOO TrianglePatch patch_between(const TrianglePatch& from, const TrianglePatch& to,
                                              float time) {
  TrianglePatch patch;
  const auto move = [time](float opening, float closing) {
    return opening + time * (closing - opening);
  };
#pragma omp simd
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float ax = move(from.a.x[i], to.a.x[i]), ay = move(from.a.y[i], to.a.y[i]);
    const float bx = move(from.b.x[i], to.b.x[i]), by = move(from.b.y[i], to.b.y[i]);
    const float cx = move(from.c.x[i], to.c.x[i]), cy = move(from.c.y[i], to.c.y[i]);
    const float az = move(from.a.z[i], to.a.z[i]), bz = move(from.b.z[i], to.b.z[i]);
    const float cz = move(from.c.z[i], to.c.z[i]);
    patch.a.x[i] = ax;
    patch.a.y[i] = ay;
    patch.a.z[i] = az;
    patch.b.x[i] = bx;
    patch.b.y[i] = by;
    patch.b.z[i] = bz;
    patch.c.x[i] = cx;
    patch.c.y[i] = cy;
    patch.c.z[i] = cz;
    patch.normal.x[i] = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
    patch.normal.y[i] = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
    patch.normal.z[i] = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  }
  return patch;
}

MIEN_FOR_AVX2_TOO float intersect_patch(const TrianglePatch& patch, const RayLanes& rays,
                                        unsigned lane, float* distances) {
  Crossings found;
  std::fill_n(distances, patch_size, infinity);
  if (cross(patch, rays, lane, found) == 0) return infinity;
  float nearest = infinity;
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float t = found.scaled[i] / found.facing[i];
    if (found.inside[i] == 0 || !(t > 0.0f)) continue;
    distances[i] = t;
    nearest = std::min(nearest, t);
  }
  return nearest;
}

MIEN_FOR_AVX2_TOO void occlude_by_patch(const TrianglePatch& patch, const RayLanes& rays,
                                        const int* valid, unsigned count, float* reach) {
  Crossings found;
  for (unsigned ray = 0; ray < count; ++ray) {
    if (valid[ray] == 0 || cross(patch, rays, ray, found) == 0) continue;
    for (std::size_t i = 0; i < patch_size; ++i) {
      const float t = found.scaled[i] / found.facing[i];
      if (found.inside[i] != 0 && t > 0.0f && t < reach[ray]) reach[ray] = -infinity;
    }
  }
}

Barycentric barycentric(const Triangle& triangle, const Vec3& point) {
  const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Vec3 normal = ab.cross(ac);
  const float squared = normal.squaredNorm();
  if (!(squared > 0.0f)) return {0.0f, 0.0f};
  const Vec3 ap = point - triangle.a;
  return {ap.cross(ac).dot(normal) / squared, ab.cross(ap).dot(normal) / squared};
}

}  // namespace mien::render
