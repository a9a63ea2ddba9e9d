#include "render/geometry/box.h"

#include <algorithm>
#include <cmath>

#include "render/math/for_avx2.h"

namespace mien::render {

Box box_of(const PreparedCone& cone) {
  const Eigen::Array3f a = cone.a.array(), b = cone.b().array();
  return {(a - cone.radius_a).min(b - cone.radius_b), (a + cone.radius_a).max(b + cone.radius_b)};
}

Box box_of(const Triangle& triangle) {
  const Eigen::Array3f a = triangle.a.array(), b = triangle.b.array(), c = triangle.c.array();
  return {a.min(b).min(c), a.max(b).max(c)};
}

Box hull(const Box& a, const Box& b) { return {a.lower.min(b.lower), a.upper.max(b.upper)}; }

Box padded(const Box& box) {
  const float padding =
      1e-4f * std::max(1.0f, std::max(box.lower.abs().maxCoeff(), box.upper.abs().maxCoeff()));
  return {box.lower - padding, box.upper + padding};
}

// Padding exceeds the rounding errors of the differences; the factor exceeds that of the products.
MIEN_FOR_AVX2_TOO void find_rays_through(const Box& box, const RayLanes& rays, const float* reach,
                                         int* may_hit) {
  const float x_low = box.lower.x(), y_low = box.lower.y(), z_low = box.lower.z();
  const float x_high = box.upper.x(), y_high = box.upper.y(), z_high = box.upper.z();
  const auto less = [](float a, float b) { return a < b ? a : b; };
  const auto more = [](float a, float b) { return a < b ? b : a; };
  // A ray along the planes of a slab enters and leaves it far away.
  const auto inverse = [&](float d) { return std::copysign(1.0f / more(std::abs(d), 1e-20f), d); };
#pragma omp simd
  for (int i = 0; i < 8; ++i) {
    const float x = inverse(rays.direction_x[i]), y = inverse(rays.direction_y[i]);
    const float z = inverse(rays.direction_z[i]);
    const float x_a = (x_low - rays.origin_x[i]) * x, x_b = (x_high - rays.origin_x[i]) * x;
    const float y_a = (y_low - rays.origin_y[i]) * y, y_b = (y_high - rays.origin_y[i]) * y;
    const float z_a = (z_low - rays.origin_z[i]) * z, z_b = (z_high - rays.origin_z[i]) * z;
    const float enter = more(more(less(x_a, x_b), less(y_a, y_b)), less(z_a, z_b));
    const float leave = less(less(more(x_a, x_b), more(y_a, y_b)), more(z_a, z_b));
    may_hit[i] =
        -static_cast<int>((enter <= leave * 1.00001f) & (leave >= 0.0f) & (enter <= reach[i]));
  }
}

}  // namespace mien::render
