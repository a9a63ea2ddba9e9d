#pragma once

#include "render/geometry/shapes.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A point of a surface and how it is seen.
struct Surface {
  Vec3 point;
  Vec3 normal;       ///< unit, on the side that is seen
  Vec3 towards_eye;  ///< unit
  Vec3 origin;       ///< where rays that leave the surface start: off it by more than its rounding
  Color albedo;      ///< the material's, with its texture
  const Material* material;
  int part = 0;  ///< index into Scene::parts
};

/// The surface of a shape at a point of it, seen along `direction`. Normals of meshes are
/// interpolated between their vertices (Phong 1975); rays leave from the curved surface that those
/// normals suggest, so that no edges of triangles show where light grazes (Hanika 2021).
/// `closing` holds the solids as they are when the shutter closes, if they move.
Surface surface_at(const Scene& scene, const Solids& solids, const Solids* closing,
                   const Shapes& shapes, int shape, const Vec3& point, const Vec3& direction,
                   float time);

/// A texture's colour, bilinearly filtered.
Color texel_at(const Texture& texture, float u, float v);

/// Radiance to the eye per irradiance from the unit direction `towards`: Lambert, plus a GGX lobe
/// when the material has a specular_f0 (Walter et al. 2007, Schlick's Fresnel term and shadowing).
Color reflectance(const Surface& surface, const Vec3& towards);

}  // namespace mien::render
