#pragma once

#include "render/scene.h"

namespace mien::render {

/// A point of a surface and how it is seen.
struct Surface {
  Vec3 point;
  Vec3 normal;       ///< unit, outward
  Vec3 towards_eye;  ///< unit
  const Material* material;
};

/// Radiance to the eye per irradiance from the unit direction `towards`: Lambert, plus a GGX lobe
/// when the material has sheen (Walter et al. 2007, Schlick's Fresnel term and shadowing).
Color reflectance(const Surface& surface, const Vec3& towards);

/// Where rays that leave the surface start: off it by more than its rounding.
Vec3 ray_origin(const Surface& surface);

}  // namespace mien::render
