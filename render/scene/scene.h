#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/math/vector.h"

namespace mien::render {

/// A diffuse surface with an optional glossy specular lobe, or one that emits light.
struct Material {
  Color albedo{0.5f, 0.5f, 0.5f};  ///< diffuse reflectance, 0…1
  float specular_f0 = 0.0f;  ///< reflectance at normal incidence (F0) of a GGX lobe, 0 (none) … 0.1
  float roughness = 0.5f;    ///< roughness of that lobe, 0.2 … 1 (alpha = roughness²)

  /// Radiance emitted equally in all directions. Only the camera sees it; it lights nothing. With a
  /// black albedo and no specular lobe the surface shows exactly this colour.
  Color emission{0.0f, 0.0f, 0.0f};
  int texture = -1;  ///< index into Scene::textures of the texture by which the albedo is
                     ///< multiplied (meshes only); −1: none

  /// Index of the tangent-space normal map in Scene::textures (meshes only; Blinn 1978, as in
  /// glTF): 2 · texel − 1 are the normal's components along increasing u, along decreasing v, and
  /// out of the surface. −1: none.
  int normal_map = -1;
  float normal_scale = 1.0f;  ///< factor of the first two components
};

/// Reflectances, or other fractions, over the unit square; the texture repeats outside it.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<Color> texels;  ///< linear Rec.709, 0…1; rows from v = 0 on, u from left to right
};

struct Sphere {
  Vec3 centre = Vec3::Zero();
  float radius = 0.05f;
  int material = 0;  ///< index into Scene::materials
  int part = 0;      ///< index into Scene::parts
};

/// A round cone (tapered capsule): the convex hull of two spheres. With equal radii it is a
/// capsule. When one sphere contains the other, the shape is the larger sphere.
struct RoundCone {
  Vec3 start = Vec3::Zero();
  Vec3 end = Vec3::UnitY();
  float start_radius = 0.05f;
  float end_radius = 0.05f;
  int material = 0;  ///< index into Scene::materials
  int part = 0;      ///< index into Scene::parts
};

/// A surface of triangles, lit on both sides.
struct Mesh {
  std::vector<Vec3> positions;           ///< positions of the vertices, metres
  std::vector<Vec3> normals;             ///< unit, one per vertex
  std::vector<std::array<float, 2>> uv;  ///< one per vertex; empty: no texture
  /// Indices of vertices. Consecutive triangles should be near each other, for speed: the tracer
  /// bounds them together. Their order also affects the grid of the sky's occlusion on the floor.
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> triangle_parts;  ///< one per triangle; empty: `part` for all
  int material = 0;                 ///< index into Scene::materials
  int part = 0;                     ///< index into Scene::parts
};

/// The shapes that rays can hit.
struct Solids {
  std::vector<Sphere> spheres;
  std::vector<RoundCone> round_cones;
  std::vector<Mesh> meshes;

  bool empty() const { return spheres.empty() && round_cones.empty() && meshes.empty(); }
};

/// A figure as a whole. With an opacity below 1 its outer surface is blended with what is behind
/// it, and its shadow is lighter in proportion. Its inside never shows.
struct Figure {
  std::string name = "figure";
  float opacity = 1.0f;  ///< 0 … 1
};

/// The name of a solid in the id layer, such as "left-knee" of the figure "target".
struct Part {
  std::string name = "body";
  int figure = 0;  ///< index into Scene::figures
};

/// The floor: the plane y = 0, seen from above only, with lines of a square grid.
///
/// The lines are filtered analytically by the pixel's footprint. With increasing horizontal
/// distance from the camera the floor fades into the backdrop, shadows included: not at all up to
/// `fade_start`, completely at `fade_end`.
struct Ground {
  Color albedo{0.5f, 0.5f, 0.5f};
  Color line_albedo{0.4f, 0.4f, 0.4f};
  float line_spacing = 1.0f;  ///< metres; 0 draws no lines at all
  float line_width = 0.012f;  ///< metres
  int major_every = 0;        ///< every n-th line has `major_albedo` and twice the width; 0: none
  Color major_albedo{0.3f, 0.3f, 0.3f};
  float offset_x = 0.0f;  ///< shift of the lines, metres: a moving ground
  float offset_z = 0.0f;
  float fade_start = 8.0f;  ///< metres
  float fade_end = 30.0f;   ///< metres, more than fade_start
};

/// A rectangle that emits `radiance` evenly towards the side of cross(half_u, half_v). It lights
/// the scene but the camera does not see it. half_u and half_v are perpendicular.
struct AreaLight {
  Vec3 centre{0.0f, 4.0f, 0.0f};
  Vec3 half_u{0.5f, 0.0f, 0.0f};  ///< from the centre to the middle of one side, metres
  Vec3 half_v{0.0f, 0.0f, 0.5f};  ///< from the centre to the middle of the next side, metres
  Color radiance{10.0f, 10.0f, 10.0f};
};

/// Returns a rectangular light of this width and height, metres, that faces from `centre` to
/// `target`. Its width is horizontal.
AreaLight softbox(const Vec3& centre, const Vec3& target, float width, float height,
                  const Color& radiance);

/// Light from all directions, and the backdrop that the camera sees where there is nothing else.
///
/// Above the horizon, radiance changes from `horizon` to `zenith` in proportion to the sine of the
/// elevation. Below it, radiance is `below`, an approximation of the light that the floor reflects:
/// constant, and occluded by solids only, never by the floor; 0 for a floor that reflects nothing.
struct Sky {
  Color zenith{0.6f, 0.6f, 0.6f};
  Color horizon{0.6f, 0.6f, 0.6f};
  Color below{0.0f, 0.0f, 0.0f};
  Color backdrop_horizon{0.6f, 0.6f, 0.6f};  ///< seen by the camera at and below the horizon
  Color backdrop_zenith{0.6f, 0.6f, 0.6f};   ///< seen by the camera straight up
};

/// Everything that a picture shows. Without `has_ground` only the backdrop is shown around the
/// solids.
///
/// `solids` may move from picture to picture; `static_solids` belong to the set like the ground,
/// and a tracer renders them once for each set and camera.
struct Scene {
  std::vector<Material> materials;
  std::vector<const Texture*> textures;   ///< must outlive the scene
  std::vector<Figure> figures{Figure{}};  ///< 1 to 32
  std::vector<Part> parts{Part{}};        ///< at least one
  Solids solids;
  Solids static_solids;           ///< their parts must exist, but are ignored
  std::vector<AreaLight> lights;  ///< at most 32
  Sky sky;
  Ground ground;
  bool has_ground = true;
};

/// Radiance of the sky's light that arrives from the unit direction `towards`.
Color sky_radiance(const Sky& sky, const Vec3& towards);

/// Irradiance divided by π on a surface with this unit normal under the whole, unoccluded sky.
Color unoccluded_sky_light(const Sky& sky, const Vec3& normal);

/// Radiance of the backdrop in the unit direction `towards`.
Color backdrop_radiance(const Sky& sky, const Vec3& towards);

/// Irradiance on an upward-facing floor under the whole, unoccluded sky.
Color sky_irradiance_on_floor(const Sky& sky);

/// Checks the scene's numbers, indices, lengths of lists and shapes of lights, but not the texels
/// of textures. Throws std::invalid_argument, which names the member, for the first fault.
void validate(const Scene& scene);

}  // namespace mien::render
