#include "render/geometry/prepared_cone.h"

#include <algorithm>
#include <cmath>

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {

PreparedCone prepared_cone(const Sphere& sphere) {
  PreparedCone cone;
  cone.a = sphere.centre;
  cone.radius_a = cone.radius_b = sphere.radius;
  cone.material = sphere.material;
  cone.part = sphere.part;
  return cone;
}

PreparedCone prepared_cone(const RoundCone& round_cone) {
  const Vec3 axis = round_cone.end - round_cone.start;
  const float slope = round_cone.start_radius - round_cone.end_radius;
  const float side_squared = axis.squaredNorm() - slope * slope;
  // Only a side that is long against the rounding of the axis is a side at all.
  if (side_squared <= 1e-6f * axis.squaredNorm()) {
    return slope >= 0.0f ? prepared_cone(Sphere{round_cone.start, round_cone.start_radius,
                                                round_cone.material, round_cone.part})
                         : prepared_cone(Sphere{round_cone.end, round_cone.end_radius,
                                                round_cone.material, round_cone.part});
  }
  PreparedCone cone;
  cone.a = round_cone.start;
  cone.axis = axis;
  cone.radius_a = round_cone.start_radius;
  cone.radius_b = round_cone.end_radius;
  cone.axis_squared = axis.squaredNorm();
  cone.slope = slope;
  cone.side_squared = side_squared;
  cone.material = round_cone.material;
  cone.part = round_cone.part;
  return cone;
}

std::vector<PreparedCone> prepared_cones(const Solids& solids) {
  std::vector<PreparedCone> cones;
  cones.reserve(solids.spheres.size() + solids.round_cones.size());
  for (const Sphere& sphere : solids.spheres) cones.push_back(prepared_cone(sphere));
  for (const RoundCone& round_cone : solids.round_cones) cones.push_back(prepared_cone(round_cone));
  return cones;
}

Vec3 normal_at(const PreparedCone& cone, const Vec3& point) {
  const Vec3 from_a = point - cone.a;
  if (cone.side_squared == 0.0f) return from_a.normalized();
  // 0 on the cap of a, side_squared on the cap of b, in between on the side.
  const float along =
      std::clamp(cone.axis.dot(from_a) - cone.radius_a * cone.slope, 0.0f, cone.side_squared);
  return (cone.side_squared * from_a - along * cone.axis).normalized();
}

namespace {

// What intersect_lines works out for both balls and the side, for one ball alone.
MIEN_FOR_AVX2_TOO void intersect_ball(const PreparedCone& cone, const RayLanes& rays,
                                      unsigned count, float* enter, float* leave) {
  const float x = cone.a.x(), y = cone.a.y(), z = cone.a.z();
  const float squared = cone.radius_a * cone.radius_a;
#pragma omp simd
  for (unsigned i = 0; i < count; ++i) {
    const float dx = rays.direction_x[i], dy = rays.direction_y[i], dz = rays.direction_z[i];
    const float ox = rays.origin_x[i] - x, oy = rays.origin_y[i] - y, oz = rays.origin_z[i] - z;
    const float nearest = -(ox * dx + oy * dy + oz * dz);
    const float px = ox + nearest * dx, py = oy + nearest * dy, pz = oz + nearest * dz;
    const float along = dx * px + dy * py + dz * pz;
    const float inside = along * along - (px * px + py * py + pz * pz) + squared;
    const float root = std::sqrt(inside > 0.0f ? inside : 0.0f);
    const bool met = inside >= 0.0f;
    enter[i] = nearest + (met ? -along - root : infinity);
    leave[i] = nearest + (met ? -along + root : -infinity);
  }
}

}  // namespace

MIEN_FOR_AVX2_TOO void intersect_lines(const PreparedCone& cone, const RayLanes& rays,
                                       unsigned count, float* enter, float* leave) {
  if (cone.side_squared == 0.0f) return intersect_ball(cone, rays, count, enter, leave);
  const float ax = cone.axis.x(), ay = cone.axis.y(), az = cone.axis.z();
  const float hx = 0.5f * ax, hy = 0.5f * ay, hz = 0.5f * az;
  const float mx = cone.a.x() + hx, my = cone.a.y() + hy, mz = cone.a.z() + hz;
  const float side = cone.side_squared;
  const float lean = cone.radius_a * cone.slope;
  const float ra_squared = cone.radius_a * cone.radius_a;
  const float rb_squared = cone.radius_b * cone.radius_b;
  const float k0_constant = cone.axis_squared * ra_squared;

#pragma omp simd
  for (unsigned i = 0; i < count; ++i) {
    const float dx = rays.direction_x[i], dy = rays.direction_y[i], dz = rays.direction_z[i];
    const float ox = rays.origin_x[i] - mx, oy = rays.origin_y[i] - my, oz = rays.origin_z[i] - mz;
    const float nearest = -(ox * dx + oy * dy + oz * dz);
    const float px = ox + nearest * dx, py = oy + nearest * dy, pz = oz + nearest * dz;
    const float pax = px + hx, pay = py + hy, paz = pz + hz;
    const float pbx = px - hx, pby = py - hy, pbz = pz - hz;

    const float axis_a = ax * pax + ay * pay + az * paz;
    const float axis_d = ax * dx + ay * dy + az * dz;
    const float d_a = dx * pax + dy * pay + dz * paz;
    const float d_b = dx * pbx + dy * pby + dz * pbz;
    const float a_a = pax * pax + pay * pay + paz * paz;
    const float b_b = pbx * pbx + pby * pby + pbz * pbz;

    const float sphere_a = d_a * d_a - a_a + ra_squared;
    const float root_a = std::sqrt(sphere_a > 0.0f ? sphere_a : 0.0f);
    float first = sphere_a >= 0.0f ? -d_a - root_a : infinity;
    float last = sphere_a >= 0.0f ? -d_a + root_a : -infinity;

    const float sphere_b = d_b * d_b - b_b + rb_squared;
    const float root_b = std::sqrt(sphere_b > 0.0f ? sphere_b : 0.0f);
    const float first_b = sphere_b >= 0.0f ? -d_b - root_b : infinity;
    const float last_b = sphere_b >= 0.0f ? -d_b + root_b : -infinity;
    first = first_b < first ? first_b : first;
    last = last_b > last ? last_b : last;

    const float k2 = side - axis_d * axis_d;
    const float k1 = side * d_a - axis_a * axis_d + axis_d * lean;
    const float k0 = side * a_a - axis_a * axis_a + 2.0f * axis_a * lean - k0_constant;
    const float discriminant = k1 * k1 - k0 * k2;
    const float root = std::sqrt(discriminant > 0.0f ? discriminant : 0.0f);
    const float q = k1 > 0.0f ? -k1 - root : -k1 + root;  // no cancellation in either root
    const float t1 = q / k2;
    const float t2 = k0 / q;
    // Comparisons with the NaN of a division by zero are false, which is what is wanted.
    const float y1 = axis_a - lean + t1 * axis_d;
    const float y2 = axis_a - lean + t2 * axis_d;
    const bool on_side_1 = (discriminant >= 0.0f) & (y1 > 0.0f) & (y1 < side);
    const bool on_side_2 = (discriminant >= 0.0f) & (y2 > 0.0f) & (y2 < side);
    first = on_side_1 & (t1 < first) ? t1 : first;
    last = on_side_1 & (t1 > last) ? t1 : last;
    first = on_side_2 & (t2 < first) ? t2 : first;
    last = on_side_2 & (t2 > last) ? t2 : last;

    enter[i] = nearest + first;
    leave[i] = nearest + last;
  }
}

MIEN_FOR_AVX2_TOO void crossings_beyond(const float* from, const float* enter, const float* leave,
                                        unsigned count, float* distance) {
#pragma omp simd
  for (unsigned i = 0; i < count; ++i) {
    const float out = leave[i] > from[i] ? leave[i] : infinity;
    const float first = enter[i] > from[i] ? enter[i] : out;
    distance[i] = enter[i] > leave[i] ? infinity : first;
  }
}

}  // namespace mien::render
