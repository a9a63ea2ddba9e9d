#pragma once

#include <vector>

#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "scenes/point_light/point_light.h"

namespace mien::scenes {

/// The colours of a point-light display, linear.
struct DotColours {
  render::Color dots;
  render::Color background;
};

/// The colours stated in the options or, by default, derived from dark_on_light and contrast.
DotColours dot_colours(const PointLightOptions& options);

/// Appends the dots at a frame, in exactly their colour under any lighting: discs that are parallel
/// to the image plane and have the stated diameter in it, or spheres if the diameter is given in
/// metres. Discs behind a perspective camera are omitted.
void add_dots(render::Scene& scene, const std::vector<Dot>& dots, int frame,
              const PointLightOptions& options, const render::Camera& camera);

}  // namespace mien::scenes
