#pragma once

#include "render/math/sampler.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A point chosen on a light, as seen from a point of a surface.
struct LightSample {
  Vec3 towards;         ///< unit
  float distance;       ///< metres
  Color perpendicular;  ///< irradiance that it represents on a surface facing it; black if the
                        ///< surface is behind the light
};

/// Samples the light uniformly by area: E[perpendicular · cos θ] is the irradiance.
LightSample sample(const AreaLight& light, const Vec3& point, Point2 u);

/// Irradiance from the whole, unoccluded light at a point with this unit normal: Lambert's formula
/// for polygons, clipped at the surface's horizon.
Color irradiance(const AreaLight& light, const Vec3& point, const Vec3& normal);

}  // namespace mien::render
