#pragma once

#include <optional>

#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

/// Radiance of the floor at a point, nothing in its way to the lights and the sky, before it fades.
/// Staging can use it to choose Sky::below.
Color unshadowed_floor(const Scene& scene, const Vec3& point);

/// What a ray from the eye shows when no solid is near: backdrop or unshadowed floor, in closed
/// form, with the grid filtered over a pixel.
struct SetPixel {
  Color radiance = Color::Zero();
  bool shows_floor = false;
  Vec3 point = Vec3::Zero();             ///< of the floor
  Color visible_albedo = Color::Zero();  ///< of the floor, times how little of it has faded
};
SetPixel set_pixel(const Scene& scene, const CameraFrame& camera, const EyeRay& ray);

/// Distance, in lengths of the direction, at which a ray meets the floor from above.
inline std::optional<float> distance_to_floor(const Vec3& origin, const Vec3& direction) {
  if (!(origin.y() > 0.0f && direction.y() < 0.0f)) return std::nullopt;
  return -origin.y() / direction.y();
}

/// Share of the interval [x − width/2, x + width/2] that lines of `line_width` centred on every
/// multiple of `spacing` cover. All metres.
float line_cover(float x, float width, float spacing, float line_width);

}  // namespace mien::render
