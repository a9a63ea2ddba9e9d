#include "render/geometry/triangle.h"

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {

std::vector<TrianglePatch> patches_of(const std::vector<Triangle>& triangles) {
  std::vector<TrianglePatch> patches((triangles.size() + patch_size - 1) / patch_size);
  const auto set = [](TrianglePatch::Corners& corners, std::size_t lane, const Vec3& corner) {
    corners.x[lane] = corner.x();
    corners.y[lane] = corner.y();
    corners.z[lane] = corner.z();
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    TrianglePatch& patch = patches[i / patch_size];
    set(patch.a, i % patch_size, triangles[i].a);
    set(patch.b, i % patch_size, triangles[i].b);
    set(patch.c, i % patch_size, triangles[i].c);
  }
  return patches;
}

TrianglePatch patch_between(const TrianglePatch& from, const TrianglePatch& to, float time) {
  TrianglePatch patch;
  const auto move = [time](const TrianglePatch::Corners& opening,
                           const TrianglePatch::Corners& closing, TrianglePatch::Corners& moved) {
    for (std::size_t i = 0; i < patch_size; ++i) {
      moved.x[i] = opening.x[i] + time * (closing.x[i] - opening.x[i]);
      moved.y[i] = opening.y[i] + time * (closing.y[i] - opening.y[i]);
      moved.z[i] = opening.z[i] + time * (closing.z[i] - opening.z[i]);
    }
  };
  move(from.a, to.a, patch.a);
  move(from.b, to.b, patch.b);
  move(from.c, to.c, patch.c);
  return patch;
}

MIEN_FOR_AVX2_TOO void intersect_patch(const TrianglePatch& patch, const Vec3& origin,
                                       const Vec3& direction, float* distance) {
  const float dx = direction.x(), dy = direction.y(), dz = direction.z();
  const float ox = origin.x(), oy = origin.y(), oz = origin.z();
#pragma omp simd
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float ax = patch.a.x[i], ay = patch.a.y[i], az = patch.a.z[i];
    const float bx = patch.b.x[i], by = patch.b.y[i], bz = patch.b.z[i];
    const float cx = patch.c.x[i], cy = patch.c.y[i], cz = patch.c.z[i];
    const float nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
    const float ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
    const float nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const float pax = ax - ox, pay = ay - oy, paz = az - oz;
    const float pbx = bx - ox, pby = by - oy, pbz = bz - oz;
    const float pcx = cx - ox, pcy = cy - oy, pcz = cz - oz;
    // Edge p → q: (q − p) × (q + p) · d.
    const auto side = [&](float px, float py, float pz, float qx, float qy, float qz) {
      const float ex = qx - px, ey = qy - py, ez = qz - pz;
      const float sx = qx + px, sy = qy + py, sz = qz + pz;
      return (ey * sz - ez * sy) * dx + (ez * sx - ex * sz) * dy + (ex * sy - ey * sx) * dz;
    };
    const float u = side(pbx, pby, pbz, pcx, pcy, pcz);
    const float v = side(pcx, pcy, pcz, pax, pay, paz);
    const float w = side(pax, pay, paz, pbx, pby, pbz);
    const bool inside =
        ((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f));
    const float facing = nx * dx + ny * dy + nz * dz;
    const float t = (nx * pax + ny * pay + nz * paz) / facing;
    distance[i] = inside & (facing != 0.0f) & (t > 0.0f) ? t : infinity;
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
