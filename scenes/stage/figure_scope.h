#pragma once

#include <functional>
#include <string>

#include "render/scene/scene.h"

namespace mien::scenes {

/// Lets `draw` append solids to a scene and makes a separate figure of them, with that name and
/// opacity: solids of part 0 get a part "body" of the figure, and parts that `draw` appends are the
/// figure's. In a scene without solids the figure takes the place of the scene's first one.
void draw_as_figure(render::Scene& scene, const std::string& name, float opacity,
                    const std::function<void()>& draw);

}  // namespace mien::scenes
