#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/geometry.h"
#include "render/scene.h"

namespace mien::scenes {

/// Names that `look: {scene: …}` takes.
std::vector<std::string> set_names();

/// The standing part of a scene: floor, light, sky. `centre` is where the action is (on the floor,
/// metres) and `forward` the unit horizontal direction that the figure faces; the key light stands
/// far off, at the figure's front right, so that it lights all of a long walk alike.
///
/// Throws Error for an unknown name.
render::Scene make_set(std::string_view name, const motion::Vec3& centre,
                       const motion::Vec3& forward);

}  // namespace mien::scenes
