#pragma once

#include <optional>
#include <vector>

#include "render/geometry/bounding_volumes.h"
#include "render/geometry/embree_scene.h"
#include "render/geometry/shadow_mask.h"
#include "render/light/floor_sky.h"
#include "render/light/static_background.h"
#include "render/math/filter.h"
#include "render/math/sampler.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"
#include "render/tracer/shared_occlusion.h"

namespace mien::render {

/// Everything that is fixed while a picture is rendered: the scene prepared for tracing, with
/// bounds and masks of where its figure may be hit or cast shadows. The scenes and the background
/// must outlive it.
struct PreparedScene {
  const Scene& scene;            ///< at time 0, when the shutter opens
  const Solids& solids;          ///< the figure's, in `scene`
  const Solids* closing_solids;  ///< at time 1, the end of the frame interval; null: nothing moves
  Quality quality;
  PixelSampler sampler;  ///< sampler of one pixel; for others use for_pixel
  CameraFrame camera;
  std::optional<CameraFrame> closing_camera;  ///< none: the camera does not move
  const Filter& filter;
  EmbreeScene figure;
  const StaticBackground& background;
  const EmbreeScene* static_solids;  ///< null if there are none
  BoundingSphere bounds;             ///< bounds of the figure
  PixelMask pixel_mask;              ///< where primary rays may hit the figure
  /// Per light: where the figure may occlude it from the floor.
  std::vector<ShadowMask> shadow_masks;
  FloorSky floor_sky;                   ///< the figure's occlusion of the sky on the floor
  SharedOcclusion shared_occlusion;     ///< what pixels share of the figure's occlusion
  std::vector<float> opacities;         ///< opacities of the figures
  const Shapes* next_shapes = nullptr;  ///< shapes in the next picture, for motion vectors

  /// Whether every sample renders its own background, because the camera moves or has an aperture.
  bool is_per_sample() const { return closing_camera || !camera.lens_right.isZero(); }
};

}  // namespace mien::render
