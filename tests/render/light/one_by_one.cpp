#include "render/light/one_by_one.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "render/light/floor.h"
#include "render/math/directions.h"

namespace mien::render::test {
namespace {

constexpr float inverse_pi = std::numbers::inv_pi_v<float>;

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

// Length of line within [0, x], for lines centred on the multiples of 1.
float cumulated_line(float x, float line) {
  const float whole = std::floor(x + 0.5f);
  return whole * line + std::clamp(x - whole, -0.5f * line, 0.5f * line);
}

/// The fraction of the interval [x − width/2, x + width/2] that lines cover, which are centred on
/// the multiples of `spacing`.
float line_cover(float x, float width, float spacing, float line_width) {
  const float line = line_width / spacing;
  const float breadth = std::max(width / spacing, 1e-6f);
  const float from = x / spacing - 0.5f * breadth;
  const float cover = cumulated_line(from + breadth, line) - cumulated_line(from, line);
  return std::clamp(cover / breadth, 0.0f, 1.0f);
}

// Widths along x and z of the parallelogram of floor that a pixel covers.
struct Footprint {
  float x;
  float z;
};

Footprint footprint(const CameraFrame& camera, const Vec3& unnormalised, float scale) {
  const Vec3 right =
      scale * (camera.step_right - (camera.step_right.y() / unnormalised.y()) * unnormalised);
  const Vec3 down =
      scale * (camera.step_down - (camera.step_down.y() / unnormalised.y()) * unnormalised);
  return {std::abs(right.x()) + std::abs(down.x()), std::abs(right.z()) + std::abs(down.z())};
}

Color albedo_at(const Ground& ground, const Vec3& point, const Footprint& print) {
  if (ground.line_spacing <= 0.0f) return ground.albedo;
  const float x = point.x() - ground.offset_x, z = point.z() - ground.offset_z;
  const auto cover = [&](float spacing, float width) {
    const float in_x = line_cover(x, print.x, spacing, width);
    const float in_z = line_cover(z, print.z, spacing, width);
    return in_x + in_z - in_x * in_z;
  };
  const Color fine = ground.albedo + cover(ground.line_spacing, ground.line_width) *
                                         (ground.line_albedo - ground.albedo);
  if (ground.major_every == 0) return fine;
  const float major =
      cover(static_cast<float>(ground.major_every) * ground.line_spacing, 2.0f * ground.line_width);
  return fine + major * (ground.major_albedo - fine);
}

Color irradiance_on_floor(const Scene& scene, const Vec3& point) {
  Color sum = sky_irradiance_on_floor(scene.sky);
  for (const AreaLight& light : scene.lights) sum += irradiance(light, point, Vec3::UnitY());
  return sum;
}

float visibility(const Ground& ground, float distance) {
  const float x = std::clamp((distance - ground.fade_start) / (ground.fade_end - ground.fade_start),
                             0.0f, 1.0f);
  return 1.0f - x * x * (3.0f - 2.0f * x);
}

/// A point of the floor that a camera ray shows.
struct FloorPoint {
  Vec3 point;
  float distance;
  float share;  // fraction of the floor's light that has not faded into the backdrop
};

std::optional<FloorPoint> visible_floor(const Ground& ground, const CameraFrame& camera,
                                        const CameraRay& ray) {
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!distance) return std::nullopt;
  Vec3 point = ray.origin + *distance * ray.direction;
  point.y() = 0.0f;
  const Vec3& eye = camera.parallel ? camera.position : ray.origin;
  const Vec3 across = point - Vec3{eye.x(), 0.0f, eye.z()};
  const float share = visibility(ground, across.norm());
  if (share <= 0.0f) return std::nullopt;
  return FloorPoint{point, *distance, share};
}

/// Axes that form a right-handed frame with a unit normal (Duff et al. 2017).
struct Tangents {
  Vec3 a;
  Vec3 b;
};

Tangents tangents(const Vec3& n) {
  const float sign = std::copysign(1.0f, n.z());
  const float a = -1.0f / (sign + n.z());
  const float b = n.x() * n.y() * a;
  return {{1.0f + sign * n.x() * n.x() * a, sign * b, -sign * n.x()},
          {b, sign + n.y() * n.y() * a, -n.y()}};
}

Vec3 around(const Vec3& normal, float x, float y, float z) {
  const Tangents frame = tangents(normal);
  return (x * frame.a + y * frame.b + z * normal).normalized();
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

Color unshadowed_floor(const Scene& scene, const Vec3& point) {
  return scene.ground.albedo * inverse_pi * irradiance_on_floor(scene, point);
}

BackgroundPixel background_pixel(const Scene& scene, const CameraFrame& camera,
                                 const CameraRay& ray) {
  const Vec3& direction = ray.direction;
  BackgroundPixel pixel;
  pixel.radiance = backdrop_radiance(scene.sky, direction);
  if (!scene.has_ground) return pixel;
  const std::optional<FloorPoint> floor = visible_floor(scene.ground, camera, ray);
  if (!floor) return pixel;

  pixel.point = floor->point;
  pixel.shows_floor = true;
  const float share = floor->share, forwards = direction.dot(camera.forward);
  const Footprint print =
      footprint(camera, direction / forwards, camera.parallel ? 1.0f : floor->distance * forwards);
  pixel.visible_albedo = share * albedo_at(scene.ground, pixel.point, print);
  pixel.radiance = (1.0f - share) * pixel.radiance +
                   pixel.visible_albedo * inverse_pi * irradiance_on_floor(scene, pixel.point);
  return pixel;
}

Vec3 cosine_direction(const Vec3& normal, Point2 u) {
  const DiscPoint p = disc_point(u);
  return around(normal, p.x, p.y, std::sqrt(std::max(0.0f, 1.0f - p.x * p.x - p.y * p.y)));
}

Vec3 cone_direction(const Vec3& axis, float cosine_of_half_angle, Point2 u) {
  const DiscPoint p = disc_point(u);
  // The squared radius is uniform, hence so is the height it is mapped to (Archimedes).
  const float squared = p.x * p.x + p.y * p.y;
  const float drop = squared * (1.0f - cosine_of_half_angle);
  const float spread = std::sqrt((1.0f - cosine_of_half_angle) * (2.0f - drop));
  return around(axis, p.x * spread, p.y * spread, 1.0f - drop);
}

LaneVectors in_all_lanes(const Vec3& value) {
  LaneVectors all;
  for (int i = 0; i < static_cast<int>(lanes); ++i) all.set(i, value);
  return all;
}

LanePoints in_all_lanes(Point2 value) {
  LanePoints all;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    all.u[i] = value.u;
    all.v[i] = value.v;
  }
  return all;
}

}  // namespace mien::render::test
