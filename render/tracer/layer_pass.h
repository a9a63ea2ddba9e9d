#pragma once

#include "render/image/layers.h"
#include "render/tracer/picture.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// The next picture, for motion.
struct NextPicture {
  const Scene* scene = nullptr;  ///< same solids in the same order
  Camera camera;
};

/// Room for all layers but the beauty, and the names of what the scene holds.
Layers empty_layers(const Scene& scene, int width, int height);

/// Fills the pixels of a part of the film, all layers but beauty and variance.
void draw_layers(const Picture& picture, const NextPicture* next, const Tile& tile, Layers& layers);

}  // namespace mien::render
