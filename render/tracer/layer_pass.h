#pragma once

#include "render/image/layers.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// Allocates all layers but the beauty and fills in the names of figures and parts.
Layers empty_layers(const Scene& scene, int width, int height);

/// Renders the pixels of `part` in all layers but beauty and variance. Motion vectors point to the
/// next picture: `next` is its scene, with the same solids in the same order (null: nothing moves),
/// and `next_camera` its camera (null: motion stays 0).
void draw_layers(const PreparedScene& prepared, const Scene* next, const Camera* next_camera,
                 const Window& part, Layers& layers);

}  // namespace mien::render
