#pragma once

#include "render/geometry/shapes.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A point of a surface and the direction from which it is seen.
struct Surface {
  Vec3 point;
  Vec3 normal;       ///< unit, on the side that is seen
  Vec3 towards_eye;  ///< unit
  Vec3 origin;   ///< start of rays that leave the surface, offset by more than the rounding error
  Color albedo;  ///< albedo of the material times its texture
  const Material* material;
  int part = 0;  ///< index into Scene::parts
};

/// Returns the surface of a shape at `point`, seen along `direction`. Normals of meshes are
/// interpolated between their vertices (Phong 1975); rays leave from the curved surface that those
/// normals imply, so that triangle edges do not show at the shadow terminator (Hanika 2021).
/// `point` may lie beside the shape, by a pixel's width; barycentric coordinates are then clamped.
/// `shape` numbers the round cones and spheres of `shapes` first, and its triangles after them. If
/// the solids move, `closing` holds them at the end of the frame interval, time 1; otherwise it is
/// null.
Surface surface_at(const Scene& scene, const Solids& solids, const Solids* closing,
                   const Shapes& shapes, int shape, const Vec3& point, const Vec3& direction,
                   float time);

/// Returns the floor at a point, diffuse, with this albedo.
Surface floor_surface(const Vec3& point, const Color& albedo);

/// Returns a texture's colour, bilinearly filtered.
Color texel_at(const Texture& texture, float u, float v);

/// The BRDF, 1/sr: radiance to the eye per irradiance from the unit direction `towards`. Lambert,
/// plus a GGX lobe when the material has a specular_f0 (Walter et al. 2007, with Schlick's Fresnel
/// term and masking-shadowing).
Color reflectance(const Surface& surface, const Vec3& towards);

}  // namespace mien::render
