#pragma once

#include <cstdint>
#include <vector>

#include "render/geometry/shapes.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A rectangle of the floor, metres.
struct FloorArea {
  float x_min;
  float x_max;
  float z_min;
  float z_max;
};

/// A grid of floor cells that marks where the shapes may occlude all or part of a light. It is
/// turned to the sides of the light, as are penumbrae, so that cells and bounds are tight.
class ShadowMask {
 public:
  ShadowMask(const AreaLight& light, const Shapes& shapes);

  /// Returns whether any point of the area may lie in umbra or penumbra.
  bool may_shade(const FloorArea& area) const;

 private:
  static constexpr int cells = 128;  // cells per side

  /// Bounds of an area of the floor in the frame of the grid.
  FloorArea turned(const FloorArea& area) const;
  int column(float x) const;
  int row(float z) const;

  float cosine_ = 1.0f;  // of the angle by which the grid is turned
  float sine_ = 0.0f;
  bool everywhere_ = false;
  FloorArea area_{0.0f, -1.0f, 0.0f, -1.0f};
  float columns_per_metre_ = 0.0f;
  float rows_per_metre_ = 0.0f;
  std::vector<std::uint8_t> touched_;
};

}  // namespace mien::render
