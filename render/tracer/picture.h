#pragma once

#include <optional>
#include <vector>

#include "render/geometry/embree_scene.h"
#include "render/geometry/reach.h"
#include "render/geometry/shadow_mask.h"
#include "render/light/floor_sky.h"
#include "render/light/standing_set.h"
#include "render/math/filter.h"
#include "render/math/sampler.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"

namespace mien::render {

/// All that is fixed while a picture is drawn: the scene made ready for tracing and what its figure
/// can touch. The scenes and the set outlive it.
struct Picture {
  const Scene& scene;            ///< when the shutter opens
  const Solids& solids;          ///< the figure's, in `scene`
  const Solids* closing_solids;  ///< when the shutter closes; null: nothing moves
  Quality quality;
  PixelSampler sampler;  ///< of one pixel; the others are its neighbours
  CameraFrame camera;
  std::optional<CameraFrame> closing_camera;  ///< none: the camera stands
  const Filter& filter;
  EmbreeScene figure;
  const StandingSet& set;
  const EmbreeScene* walls;              ///< the standing solids; null without
  BoundingSphere bounds;                 ///< of the figure
  FilmMask film_mask;                    ///< where primary rays may meet the figure
  std::vector<ShadowMask> shadow_masks;  ///< where it may hide each light from the floor
  std::uint32_t line_lights;  ///< bit i: what it hides of light i from the floor is found by lines
  std::vector<std::vector<int>> casters;  ///< of each light, the round cones that are not behind it
  FloorSky floor_sky;                     ///< what it hides of the sky from the floor
  std::vector<float> opacities;           ///< of the figures
  const Shapes* next_shapes = nullptr;    ///< the figure's in the next picture, for motion

  /// Every sample is drawn by itself, set and all: nothing about the set is the same for all rays
  /// of a pixel.
  bool piecemeal() const { return closing_camera || !camera.lens_right.isZero(); }
};

}  // namespace mien::render
