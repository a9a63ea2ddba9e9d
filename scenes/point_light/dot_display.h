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

/// The colours that the options give, or those of polarity and contrast.
DotColours dot_colours(const PointLightOptions& options);

/// Appends the dots at a frame, in exactly their colour whatever the light: discs that face the
/// image plane and have the stated diameter there, or balls where a diameter in metres is given.
/// Dots behind the camera are left out.
void add_dots(render::Scene& scene, const std::vector<Dot>& dots, int frame,
              const PointLightOptions& options, const render::Camera& camera);

}  // namespace mien::scenes
