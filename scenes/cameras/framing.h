#pragma once

#include <array>
#include <vector>

#include "motion/math/geometry.h"
#include "render/scene/camera.h"

namespace mien::scenes {

/// Projection and size of a camera.
struct Lens {
  double fov_radians = 26.0 * motion::radians_per_degree;  ///< vertical field of view
  bool orthographic = false;
  std::array<int, 2> size{960, 540};  ///< pixels
};

/// A camera at `position` that looks at `target`. An orthographic camera covers the height that a
/// perspective one with this field of view covers at the target's distance.
render::Camera look_at_camera(const motion::Vec3& position, const motion::Vec3& target,
                              const Lens& lens);

/// A camera in the direction `towards` (unit) from the points, at such a distance that all points,
/// as spheres with a radius of `margin` metres, fill the picture except for 12 % of its width or
/// height. Distance and position follow in closed form from the spheres that reach farthest to each
/// side.
render::Camera framing(const std::vector<motion::Vec3>& points, double margin,
                       const motion::Vec3& towards, const Lens& lens);

}  // namespace mien::scenes
