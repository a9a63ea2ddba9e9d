#include "render/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/math/constants.h"
#include "render/math/directions.h"

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
  require(material.specular_f0 >= 0.0f && material.specular_f0 <= 0.1f, where + ".specular_f0",
          "not within 0 … 0.1");
  require(material.roughness >= 0.2f && material.roughness <= 1.0f, where + ".roughness",
          "not within 0.2 … 1");
}

void validate_emission(const Material& material, const std::string& where) {
  require(is_light(material.emission), where + ".emission", "negative or not finite");
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
  require(is_reflectance(ground.major_albedo) && ground.major_every >= 0, "ground",
          "major lines are not a reflectance or not counted from 0");
  require(std::isfinite(ground.offset_x) && std::isfinite(ground.offset_z), "ground",
          "an offset is not finite");
  require(ground.fade_start >= 0.0f && ground.fade_end > ground.fade_start &&
              std::isfinite(ground.fade_end),
          "ground", "fade_end is not beyond fade_start");
}

/// The indices that solids may use.
struct Counts {
  int materials;
  int parts;
};

void require_index(int index, int count, const std::string& where) {
  require(index >= 0 && index < count, where, "out of range");
}

// Without a branch for each, since there are many.
bool are_finite(const std::vector<Vec3>& vectors) {
  float none = 0.0f;  // no number if any of the vectors is not finite
  for (const Vec3& vector : vectors)
    none += 0.0f * vector.x() + 0.0f * vector.y() + 0.0f * vector.z();
  return none == 0.0f;
}

bool are_below(const std::vector<int>& indices, int count) {
  return std::ranges::all_of(indices, [&](int index) { return index >= 0 && index < count; });
}

void validate(const Mesh& mesh, const Counts& counts, const std::string& where) {
  const auto vertices = static_cast<int>(mesh.positions.size());
  require(mesh.normals.size() == mesh.positions.size(), where + ".normals", "not one per vertex");
  require(mesh.uv.empty() || mesh.uv.size() == mesh.positions.size(), where + ".uv",
          "not one per vertex");
  require(mesh.triangle_parts.empty() || mesh.triangle_parts.size() == mesh.triangles.size(),
          where + ".triangle_parts", "not one per triangle");
  require(are_finite(mesh.positions), where + ".positions", "not finite");
  require(are_finite(mesh.normals), where + ".normals", "not finite");
  require(
      std::ranges::all_of(
          mesh.uv, [](const auto& uv) { return std::abs(uv[0]) < 1e6f && std::abs(uv[1]) < 1e6f; }),
      where + ".uv", "not within ±1e6");
  require(std::ranges::all_of(mesh.triangles,
                              [&](const auto& triangle) {
                                return std::ranges::all_of(triangle, [&](int vertex) {
                                  return vertex >= 0 && vertex < vertices;
                                });
                              }),
          where + ".triangles", "a vertex is out of range");
  require(are_below(mesh.triangle_parts, counts.parts), where + ".triangle_parts", "out of range");
  require_index(mesh.material, counts.materials, where + ".material");
  require_index(mesh.part, counts.parts, where + ".part");
}

void validate(const Solids& solids, const Counts& counts, const std::string& prefix) {
  for (std::size_t i = 0; i < solids.spheres.size(); ++i) {
    const Sphere& sphere = solids.spheres[i];
    const std::string where = prefix + indexed("spheres", i);
    require(sphere.centre.allFinite(), where + ".centre", "not finite");
    require(is_radius(sphere.radius), where + ".radius", "negative or not finite");
    require_index(sphere.material, counts.materials, where + ".material");
    require_index(sphere.part, counts.parts, where + ".part");
  }
  for (std::size_t i = 0; i < solids.round_cones.size(); ++i) {
    const RoundCone& round_cone = solids.round_cones[i];
    const std::string where = prefix + indexed("round_cones", i);
    require(round_cone.start.allFinite() && round_cone.end.allFinite(), where,
            "an end is not finite");
    require(is_radius(round_cone.start_radius) && is_radius(round_cone.end_radius), where,
            "a radius is negative or not finite");
    require_index(round_cone.material, counts.materials, where + ".material");
    require_index(round_cone.part, counts.parts, where + ".part");
  }
  for (std::size_t i = 0; i < solids.meshes.size(); ++i)
    validate(solids.meshes[i], counts, prefix + indexed("meshes", i));
}

void validate_figures(const Scene& scene) {
  require(!scene.figures.empty() && scene.figures.size() <= 32, "figures", "not 1 … 32");
  require(!scene.parts.empty(), "parts", "there is none");
  for (std::size_t i = 0; i < scene.figures.size(); ++i)
    require(scene.figures[i].opacity >= 0.0f && scene.figures[i].opacity <= 1.0f,
            indexed("figures", i) + ".opacity", "not within 0 … 1");
  for (std::size_t i = 0; i < scene.parts.size(); ++i)
    require_index(scene.parts[i].figure, static_cast<int>(scene.figures.size()),
                  indexed("parts", i) + ".figure");
}

void validate_textures(const Scene& scene) {
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture* texture = scene.textures[i];
    require(texture != nullptr && texture->width > 0 && texture->height > 0 &&
                texture->texels.size() == static_cast<std::size_t>(texture->width) *
                                              static_cast<std::size_t>(texture->height),
            indexed("textures", i), "does not have as many texels as its size implies");
  }
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

Color unoccluded_sky_light(const Sky& sky, const Vec3& normal) {
  // With the angle β between the normal and the zenith,
  // ∫ max(ω·up, 0) max(ω·n, 0) dω = ⅔ (sin β + (π − β) cos β), over the sphere.
  const float cosine = std::clamp(normal.y(), -1.0f, 1.0f);
  const float sine = std::sqrt(1.0f - cosine * cosine);
  const float angle = 0.5f * pi - std::copysign(arc_sine(std::abs(cosine)), cosine);
  const float above = 0.5f + 0.5f * cosine;
  const float rising = (2.0f / (3.0f * pi)) * (sine + (pi - angle) * cosine);
  return above * sky.horizon + rising * (sky.zenith - sky.horizon) + (1.0f - above) * sky.below;
}

Color backdrop_radiance(const Sky& sky, const Vec3& towards) {
  return sky.backdrop_horizon +
         elevation_sine(towards) * (sky.backdrop_zenith - sky.backdrop_horizon);
}

Color sky_irradiance_on_floor(const Sky& sky) {
  // ∫ (h + (z − h) cos θ) cos θ dω = π h + (z − h) 2π/3
  return pi * (sky.horizon + (2.0f / 3.0f) * (sky.zenith - sky.horizon));
}

void validate(const Scene& scene) {
  const Counts counts{static_cast<int>(scene.materials.size()),
                      static_cast<int>(scene.parts.size())};
  validate_figures(scene);
  validate_textures(scene);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Material& material = scene.materials[i];
    validate(material, indexed("materials", i));
    validate_emission(material, indexed("materials", i));
    require(material.texture >= -1 && material.texture < static_cast<int>(scene.textures.size()),
            indexed("materials", i) + ".texture", "out of range");
    require(
        material.normal_map >= -1 && material.normal_map < static_cast<int>(scene.textures.size()),
        indexed("materials", i) + ".normal_map", "out of range");
    require(std::isfinite(material.normal_scale), indexed("materials", i) + ".normal_scale",
            "not finite");
  }
  validate(scene.solids, counts, "");
  validate(scene.static_solids, counts, "static_solids.");
  require(scene.lights.size() <= 32, "lights", "more than 32");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    validate(scene.lights[i], indexed("lights", i));
  validate(scene.sky);
  if (scene.has_ground) validate(scene.ground);
}

}  // namespace mien::render
