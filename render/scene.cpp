#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace mien::render {
namespace {

std::string indexed(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

void require(bool holds, const std::string& where, const char* wrong) {
  if (!holds) throw std::invalid_argument(where + ": " + wrong);
}

bool is_reflectance(const Color& color) {
  return color.allFinite() && (color >= 0.0f).all() && (color <= 1.0f).all();
}

bool is_light(const Color& color) { return color.allFinite() && (color >= 0.0f).all(); }

bool is_radius(float radius) { return std::isfinite(radius) && radius >= 0.0f; }

void validate(const Material& material, const std::string& where) {
  require(is_reflectance(material.albedo), where + ".albedo", "not within 0 … 1");
  require(material.sheen >= 0.0f && material.sheen <= 0.1f, where + ".sheen", "not within 0 … 0.1");
  require(material.roughness >= 0.2f && material.roughness <= 1.0f, where + ".roughness",
          "not within 0.2 … 1");
}

void validate(const AreaLight& light, const std::string& where) {
  require(light.centre.allFinite(), where + ".centre", "not finite");
  const float area = light.half_u.cross(light.half_v).norm();
  require(std::isfinite(area) && area > 0.0f, where, "has no area");
  require(std::abs(light.half_u.dot(light.half_v)) <= 1e-3f * area, where,
          "half_u and half_v are not perpendicular");
  require(is_light(light.radiance), where + ".radiance", "negative or not finite");
}

void validate(const Sky& sky) {
  require(is_light(sky.zenith) && is_light(sky.horizon) && is_light(sky.below) &&
              is_light(sky.backdrop_horizon) && is_light(sky.backdrop_zenith),
          "sky", "a radiance is negative or not finite");
}

void validate(const Ground& ground) {
  require(is_reflectance(ground.albedo) && is_reflectance(ground.line_albedo), "ground",
          "an albedo is not within 0 … 1");
  require(ground.line_spacing >= 0.0f && ground.line_width >= 0.0f &&
              (ground.line_spacing == 0.0f || ground.line_width <= ground.line_spacing),
          "ground", "lines are wider than their spacing");
  require(ground.fade_start >= 0.0f && ground.fade_end > ground.fade_start &&
              std::isfinite(ground.fade_end),
          "ground", "fade_end is not beyond fade_start");
}

float elevation_sine(const Vec3& towards) { return std::clamp(towards.y(), 0.0f, 1.0f); }

}  // namespace

AreaLight softbox(const Vec3& centre, const Vec3& target, float width, float height,
                  const Color& radiance) {
  const Vec3 axis = (target - centre).normalized();
  const Vec3 up = std::abs(axis.y()) < 0.999f ? Vec3::UnitY() : Vec3::UnitZ();
  const Vec3 u = up.cross(axis).normalized();
  const Vec3 v = axis.cross(u);
  return {centre, 0.5f * width * u, 0.5f * height * v, radiance};
}

Color sky_radiance(const Sky& sky, const Vec3& towards) {
  if (towards.y() < 0.0f) return sky.below;
  return sky.horizon + elevation_sine(towards) * (sky.zenith - sky.horizon);
}

Color backdrop_radiance(const Sky& sky, const Vec3& towards) {
  return sky.backdrop_horizon +
         elevation_sine(towards) * (sky.backdrop_zenith - sky.backdrop_horizon);
}

Color sky_irradiance_on_floor(const Sky& sky) {
  // ∫ (h + (z − h) cos θ) cos θ dω = π h + (z − h) 2π/3
  constexpr float pi = std::numbers::pi_v<float>;
  return pi * (sky.horizon + (2.0f / 3.0f) * (sky.zenith - sky.horizon));
}

void validate(const Scene& scene) {
  const auto material_count = static_cast<int>(scene.materials.size());
  const auto has_material = [&](int index) { return index >= 0 && index < material_count; };
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    validate(scene.materials[i], indexed("materials", i));
  for (std::size_t i = 0; i < scene.solids.spheres.size(); ++i) {
    const Sphere& sphere = scene.solids.spheres[i];
    const std::string where = indexed("spheres", i);
    require(sphere.centre.allFinite(), where + ".centre", "not finite");
    require(is_radius(sphere.radius), where + ".radius", "negative or not finite");
    require(has_material(sphere.material), where + ".material", "out of range");
  }
  for (std::size_t i = 0; i < scene.solids.capsules.size(); ++i) {
    const Capsule& capsule = scene.solids.capsules[i];
    const std::string where = indexed("capsules", i);
    require(capsule.start.allFinite() && capsule.end.allFinite(), where, "an end is not finite");
    require(is_radius(capsule.start_radius) && is_radius(capsule.end_radius), where,
            "a radius is negative or not finite");
    require(has_material(capsule.material), where + ".material", "out of range");
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    validate(scene.lights[i], indexed("lights", i));
  validate(scene.sky);
  if (scene.has_ground) validate(scene.ground);
}

}  // namespace mien::render
