#pragma once

#include "render/scene/scene.h"
#include "scenes/sets/set_plan.h"

namespace mien::scenes {

/// The six faces of a box as triangles, flat, normals outwards.
render::Mesh box_mesh(const Box& box, const Place& place, int material);

}  // namespace mien::scenes
