#include "render/light/floor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/light/light.h"

namespace mien::render {
namespace {

constexpr float inverse_pi = std::numbers::inv_pi_v<float>;

// Length of line within [0, x], for lines centred on the multiples of 1.
float cumulated_line(float x, float line) {
  const float whole = std::floor(x + 0.5f);
  return whole * line + std::clamp(x - whole, -0.5f * line, 0.5f * line);
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

}  // namespace

float line_cover(float x, float width, float spacing, float line_width) {
  const float line = line_width / spacing;
  const float breadth = std::max(width / spacing, 1e-6f);
  const float from = x / spacing - 0.5f * breadth;
  const float cover = cumulated_line(from + breadth, line) - cumulated_line(from, line);
  return std::clamp(cover / breadth, 0.0f, 1.0f);
}

Color unshadowed_floor(const Scene& scene, const Vec3& point) {
  return scene.ground.albedo * inverse_pi * irradiance_on_floor(scene, point);
}

std::optional<FloorPoint> visible_floor(const Ground& ground, const CameraFrame& camera,
                                        const CameraRay& ray) {
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!distance) return std::nullopt;
  Vec3 point = ray.origin + *distance * ray.direction;
  point.y() = 0.0f;
  const Vec3 across = point - Vec3{camera.position.x(), 0.0f, camera.position.z()};
  const float share = visibility(ground, across.norm());
  if (share <= 0.0f) return std::nullopt;
  return FloorPoint{point, *distance, share};
}

Color albedo_at(const Ground& ground, const Vec3& point) {
  return albedo_at(ground, point, {0.0f, 0.0f});
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

}  // namespace mien::render
