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

/// What set_pixel (floor.h) tells of one ray, up to rounding and what is interpolated (OpenRow), of
/// eight.
struct LaneSetPixels {
  LaneColors radiance;
  LaneColors visible_albedo;
  LaneVectors point;   ///< of the floor
  LaneFloats share;    ///< of the floor, which the rest has faded from; 0: it is not shown
  bool plain = false;  ///< all show floor without lines, of which nothing has faded
};

/// The set through one camera where no solid is near: backdrop or unshadowed floor, in closed form.
/// The scene outlives it.
class OpenSet {
 public:
  OpenSet(const Scene& scene, const CameraFrame& camera);

 private:
  friend class OpenRow;
  const Scene& scene_;
  CameraFrame camera_;
  std::vector<FloorLight> lights_;
  std::vector<float> heights_;  // of the lights' lowest points above the floor, metres
};

/// A row of it, eight pixels at a time. Along a row lights change smoothly: before a perspective
/// camera that stands upright, in rows of which nothing has faded, and where eight pixels are
/// less than a twentieth of a light's height apart on the floor, its light is interpolated between
/// every eighth by polynomials of third degree, which errs by less than 0.00002 of it (as the
/// fourth derivative of what a point of light there gives tells; lights of some size less).
class OpenRow {
 public:
  OpenRow(const OpenSet& set, int y, int width);

  /// Through the middles of the pixels x … x + 7 of the row; x is a multiple of eight.
  LaneSetPixels pixels(int x) const;

 private:
  LaneFloats light_at(std::size_t light, int x, const LaneVectors& points) const;

  const OpenSet& set_;
  FloorRow row_;
  float down_;                             // from the optical axis, pixels
  bool is_unfaded_;                        // all pixels show floor of which nothing has faded
  std::vector<std::vector<float>> nodes_;  // of each light: what it gives pixels −8, 0, 8 …; none
                                           // where it is not interpolated
};

}  // namespace mien::render
