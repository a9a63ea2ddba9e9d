#pragma once

#include <vector>

#include "render/light/floor_row.h"
#include "render/light/lanes.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A colour a lane.
struct LaneColors {
  LaneFloats red;
  LaneFloats green;
  LaneFloats blue;
};

/// What set_pixel (floor.h) tells of one ray, up to rounding, of eight.
struct LaneSetPixels {
  LaneColors radiance;
  LaneColors visible_albedo;
  LaneVectors point;  ///< of the floor
  LaneFloats share;   ///< of the floor, which the rest has faded from; 0: it is not shown
};

/// The set through one camera where no solid is near: backdrop or unshadowed floor, in closed form,
/// eight pixels at a time. The scene outlives it.
class OpenSet {
 public:
  OpenSet(const Scene& scene, const CameraFrame& camera);

  /// Through the middles of the pixels (x, y) … (x + 7, y), whose row shows that floor.
  LaneSetPixels pixels(const FloorRow& row, int x, int y) const;

 private:
  const Scene& scene_;
  CameraFrame camera_;
  std::vector<FloorLight> lights_;
};

}  // namespace mien::render
