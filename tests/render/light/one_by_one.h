#pragma once

#include "render/math/lanes.h"
#include "render/math/sampler.h"
#include "render/math/vector.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

// Light by the formulas of one point at a time: oracles for what the renderer computes for eight.

namespace mien::render::test {

/// Irradiance from the whole, unoccluded light at a point with this unit normal: Lambert's formula
/// for polygons, clipped at the surface's horizon.
Color irradiance(const AreaLight& light, const Vec3& point, const Vec3& normal);

/// A point of the light and the irradiance that it represents on a surface facing it.
struct LightSample {
  Vec3 towards;
  float distance;
  Color perpendicular;
};
LightSample sample(const AreaLight& light, const Vec3& point, Point2 u);

/// Radiance of the floor at a point, without grid lines, shadows or fading.
Color unshadowed_floor(const Scene& scene, const Vec3& point);

/// What a camera ray shows where there are no solids.
struct BackgroundPixel {
  Color radiance = Color::Zero();
  bool shows_floor = false;
  Vec3 point = Vec3::Zero();
  Color visible_albedo = Color::Zero();
};
BackgroundPixel background_pixel(const Scene& scene, const CameraFrame& camera,
                                 const CameraRay& ray);

/// Unit direction about `normal` with density cos θ / π.
Vec3 cosine_direction(const Vec3& normal, Point2 u);

/// Unit direction within a cone about `axis`, of even density.
Vec3 cone_direction(const Vec3& axis, float cosine_of_half_angle, Point2 u);

/// The same value in every lane.
LaneVectors in_all_lanes(const Vec3& value);
LanePoints in_all_lanes(Point2 value);

}  // namespace mien::render::test
