#include "render/light/light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/math/directions.h"

namespace mien::render {
namespace {

// A rectangle cut by a plane has five corners at most.
struct Polygon {
  std::array<Vec3, 5> corners;
  std::size_t size = 0;

  void add(const Vec3& corner) { corners[size++] = corner; }
};

Polygon above_horizon(const std::array<Vec3, 4>& corners, const Vec3& normal) {
  Polygon kept;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& here = corners[i];
    const Vec3& next = corners[(i + 1) % 4];
    const float height = here.dot(normal);
    const float next_height = next.dot(normal);
    if (height >= 0.0f) kept.add(here);
    if ((height < 0.0f) != (next_height < 0.0f))
      kept.add(here + (height / (height - next_height)) * (next - here));
  }
  return kept;
}

// Angle between unit vectors over its sine.
float angle_over_sine(const Vec3& a, const Vec3& b, float sine) {
  const float half_chord = std::min(0.5f * (a - b).norm(), 1.0f);
  return sine > 1e-6f ? 2.0f * arc_sine(half_chord) / sine : 1.0f;
}

}  // namespace

LightSample sample(const AreaLight& light, const Vec3& point, Point2 u) {
  const Vec3 there =
      light.centre + (2.0f * u.u - 1.0f) * light.half_u + (2.0f * u.v - 1.0f) * light.half_v;
  const Vec3 span = there - point;
  const float squared = span.squaredNorm();
  const float distance = std::sqrt(squared);
  const Vec3 towards = span / distance;
  // Its length is a quarter of the light's area.
  const Vec3 quarter = light.half_u.cross(light.half_v);
  const float facing = -4.0f * quarter.dot(towards);
  const float share = facing > 0.0f ? facing / squared : 0.0f;
  return {towards, distance, share * light.radiance};
}

Color irradiance(const AreaLight& light, const Vec3& point, const Vec3& normal) {
  const Vec3 centre = light.centre - point;
  if (light.half_u.cross(light.half_v).dot(centre) >= 0.0f) return Color::Zero();
  const Vec3 &u = light.half_u, &v = light.half_v;
  // This order makes the sum positive for the side that emits.
  const Polygon polygon =
      above_horizon({centre - u - v, centre - u + v, centre + u + v, centre + u - v}, normal);
  if (polygon.size < 3) return Color::Zero();

  float sum = 0.0f;
  Vec3 here = polygon.corners[polygon.size - 1].normalized();
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec3 next = polygon.corners[i].normalized();
    const Vec3 across = here.cross(next);
    sum += angle_over_sine(here, next, across.norm()) * across.dot(normal);
    here = next;
  }
  return std::max(0.5f * sum, 0.0f) * light.radiance;
}

}  // namespace mien::render
