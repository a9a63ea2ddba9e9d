#pragma once

#include <optional>

#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

/// Radiance of the floor at a point, without grid lines, shadows or fading; the reference for tests
/// of sets and lights.
Color unshadowed_floor(const Scene& scene, const Vec3& point);

/// The backdrop or unshadowed floor that a camera ray shows where there are no solids, in closed
/// form, with the grid filtered over the pixel's footprint.
struct BackgroundPixel {
  Color radiance = Color::Zero();
  bool shows_floor = false;
  Vec3 point = Vec3::Zero();             ///< on the floor, world space, metres
  Color visible_albedo = Color::Zero();  ///< albedo of the floor times its share that has not faded
};
BackgroundPixel background_pixel(const Scene& scene, const CameraFrame& camera,
                                 const CameraRay& ray);

/// A point of the floor that a camera ray shows.
struct FloorPoint {
  Vec3 point;
  float distance;  ///< along the ray, metres
  float share;     ///< fraction of the floor's light that has not faded into the backdrop, above 0
};
std::optional<FloorPoint> visible_floor(const Ground& ground, const CameraFrame& camera,
                                        const CameraRay& ray);

/// The floor's albedo at a point, its lines unfiltered.
Color albedo_at(const Ground& ground, const Vec3& point);

/// Returns the distance, in multiples of the direction's length, at which a ray hits the floor from
/// above; nothing if it does not.
inline std::optional<float> distance_to_floor(const Vec3& origin, const Vec3& direction) {
  if (!(origin.y() > 0.0f && direction.y() < 0.0f)) return std::nullopt;
  return -origin.y() / direction.y();
}

/// Returns the fraction of the interval [x − width/2, x + width/2] that is covered by lines of
/// `line_width`, centred on the multiples of `spacing`. All in metres.
float line_cover(float x, float width, float spacing, float line_width);

}  // namespace mien::render
