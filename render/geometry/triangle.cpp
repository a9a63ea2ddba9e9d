#include "render/geometry/triangle.h"

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {

MIEN_FOR_AVX2_TOO void intersect_triangle(const Triangle& triangle, const RayLanes& rays,
                                          unsigned count, float* distance) {
  const float ax = triangle.a.x(), ay = triangle.a.y(), az = triangle.a.z();
  const float bx = triangle.b.x(), by = triangle.b.y(), bz = triangle.b.z();
  const float cx = triangle.c.x(), cy = triangle.c.y(), cz = triangle.c.z();
  const float nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
  const float ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
  const float nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);

#pragma omp simd
  for (unsigned i = 0; i < count; ++i) {
    const float dx = rays.direction_x[i], dy = rays.direction_y[i], dz = rays.direction_z[i];
    const float ox = rays.origin_x[i], oy = rays.origin_y[i], oz = rays.origin_z[i];
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
