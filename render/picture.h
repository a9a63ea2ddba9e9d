#pragma once

#include <vector>

#include "render/camera.h"
#include "render/embree_scene.h"
#include "render/filter.h"
#include "render/quality.h"
#include "render/reach.h"
#include "render/scene.h"

namespace mien::render {

/// All that is fixed while a picture is drawn: the scene made ready for tracing and what its figure
/// can touch. `scene` outlives it.
struct Picture {
  const Scene& scene;
  Quality quality;
  CameraFrame camera;
  Filter filter;
  EmbreeScene figure;
  BoundingSphere bounds;                 ///< of the figure
  FilmMask film_mask;                    ///< where primary rays may meet the figure
  std::vector<ShadowMask> shadow_masks;  ///< where it may hide each light from the floor
};

Picture prepare(const EmbreeDevice& device, const Scene& scene, const Camera& camera,
                const Quality& quality);

}  // namespace mien::render
