#pragma once

#include <vector>

#include "render/vector.h"

namespace mien::render {

/// Diffuse surface with an optional soft sheen from the lights.
struct Material {
  Color albedo{0.5f, 0.5f, 0.5f};  ///< diffuse reflectance, 0…1
  float sheen = 0.0f;      ///< reflectance at normal incidence of a GGX lobe, 0 (none) … 0.1
  float roughness = 0.5f;  ///< of that lobe, 0.2 … 1 (alpha = roughness²)
};

struct Sphere {
  Vec3 centre = Vec3::Zero();
  float radius = 0.05f;
  int material = 0;  ///< index into Scene::materials
};

/// A round cone: the convex hull of two spheres. Equal radii make a capsule. When one sphere holds
/// the other, the shape is that sphere.
struct Capsule {
  Vec3 start = Vec3::Zero();
  Vec3 end = Vec3::UnitY();
  float start_radius = 0.05f;
  float end_radius = 0.05f;
  int material = 0;  ///< index into Scene::materials
};

/// The floor: the plane y = 0, seen from above only, with lines of a square grid.
///
/// The lines are filtered analytically by the pixel's footprint. With the distance along the floor
/// from the camera it fades into the backdrop, shadows included: untouched up to `fade_start`, gone
/// at `fade_end`.
struct Ground {
  Color albedo{0.5f, 0.5f, 0.5f};
  Color line_albedo{0.4f, 0.4f, 0.4f};
  float line_spacing = 1.0f;  ///< metres; 0 draws no grid
  float line_width = 0.012f;  ///< metres
  float fade_start = 8.0f;    ///< metres
  float fade_end = 30.0f;     ///< metres, more than fade_start
};

/// A rectangle that emits `radiance` evenly towards the side of cross(half_u, half_v). It lights
/// the scene but the camera does not see it. half_u and half_v are perpendicular.
struct AreaLight {
  Vec3 centre{0.0f, 4.0f, 0.0f};
  Vec3 half_u{0.5f, 0.0f, 0.0f};  ///< from the centre to the middle of one side, metres
  Vec3 half_v{0.0f, 0.0f, 0.5f};  ///< from the centre to the middle of the next side, metres
  Color radiance{10.0f, 10.0f, 10.0f};
};

/// A light of that size, upright, whose axis goes from `centre` through `target`.
AreaLight softbox(const Vec3& centre, const Vec3& target, float width, float height,
                  const Color& radiance);

/// Light from all around, and what the camera sees where there is nothing.
///
/// From above the horizon, radiance goes from `horizon` to `zenith` in proportion to the sine of
/// the elevation. From below comes `below`, the light that the floor is taken to give back:
/// constant, and hidden only by spheres and capsules, never by the floor. A floor that gives
/// nothing back is `below` = 0.
struct Sky {
  Color zenith{0.6f, 0.6f, 0.6f};
  Color horizon{0.6f, 0.6f, 0.6f};
  Color below{0.0f, 0.0f, 0.0f};
  Color backdrop_horizon{0.6f, 0.6f, 0.6f};  ///< seen by the camera at and below the horizon
  Color backdrop_zenith{0.6f, 0.6f, 0.6f};   ///< seen by the camera straight up
};

/// Everything that a picture shows. `has_ground` false leaves the backdrop alone.
struct Scene {
  std::vector<Material> materials;
  std::vector<Sphere> spheres;
  std::vector<Capsule> capsules;
  std::vector<AreaLight> lights;
  Sky sky;
  Ground ground;
  bool has_ground = true;
};

/// Radiance of the sky's light that arrives from the unit direction `towards`.
Color sky_radiance(const Sky& sky, const Vec3& towards);

/// What the camera sees in the unit direction `towards` where there is nothing.
Color backdrop_radiance(const Sky& sky, const Vec3& towards);

/// Irradiance on an upward-facing floor under the whole sky, nothing in the way.
Color sky_irradiance_on_floor(const Sky& sky);

/// Throws std::invalid_argument, naming the member, when a number is not finite, a radius is
/// negative, a material index is out of range or a light has no area.
void validate(const Scene& scene);

}  // namespace mien::render
