#pragma once

#include "render/image/layers.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// The next picture's scene and camera, for motion vectors.
struct NextScene {
  const Scene* scene = nullptr;  ///< same solids in the same order; null: nothing moves
  Camera camera;
};

/// Allocates all layers but the beauty and fills in the names of figures and parts.
Layers empty_layers(const Scene& scene, int width, int height);

/// Renders the pixels of a tile in all layers but beauty and variance. Without `next`, motion stays
/// 0.
void draw_layers(const PreparedScene& prepared, const NextScene* next, const Tile& tile,
                 Layers& layers);

}  // namespace mien::render
