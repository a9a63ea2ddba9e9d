#pragma once

#include <vector>

#include "render/light/floor.h"
#include "render/light/light.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

/// Eight colours, one per lane.
struct LaneColors {
  LaneFloats red;
  LaneFloats green;
  LaneFloats blue;

  Color at(int i) const { return {red[i], green[i], blue[i]}; }
};

/// What eight camera rays show where there are no solids.
struct LaneBackground {
  LaneColors radiance;
  LaneColors visible_albedo;  ///< albedo of the floor times its share that has not faded
  LaneVectors point;          ///< point of the floor
  LaneFloats share;           ///< share of the floor that has not faded; 0: no floor is shown
};

/// The background of a scene through one camera, without solids and their shadows: backdrop and
/// floor, in closed form, with the floor's lines filtered by a pixel's footprint. The scene must
/// outlive it.
class UnshadowedBackground {
 public:
  UnshadowedBackground(const Scene& scene, const CameraFrame& camera);

  /// The background of any eight rays of the camera. The distance by which the floor fades is
  /// measured from a ray's origin; for an orthographic camera, from the camera.
  LaneBackground along(const LaneRays& rays) const;

 private:
  friend class UnshadowedRow;
  template <class LightAt>
  LaneBackground shown(const LaneRays& rays, const LightAt& light_at) const;

  const Scene& scene_;
  CameraFrame camera_;
  std::vector<FloorLight> lights_;
  std::vector<float> heights_;  // heights of the lights' lowest points above the floor, metres
};

/// A row of an UnshadowedBackground, eight pixels at a time. A light's irradiance is computed at
/// every eighth pixel and interpolated by cubic polynomials where the relative error is at most
/// 0.00002 (by the fourth derivative of a point light's irradiance; that of larger lights varies
/// less). This holds for a perspective camera with a level horizon if the distance between the
/// floor points shown by pixels eight columns apart is at most a twentieth of the height of the
/// light's lowest point.
class UnshadowedRow {
 public:
  UnshadowedRow(const UnshadowedBackground& background, int y, int width);

  /// Returns the background at the centres of the pixels x … x + 7 of the row; x is a multiple of
  /// eight.
  LaneBackground pixels(int x) const;

 private:
  LaneFloats light_at(std::size_t light, int x, const LaneVectors& points) const;

  const UnshadowedBackground& background_;
  float y_;  // of the pixels' centres
  // Per light: irradiance at pixels −8, 0, 8, …, if interpolated.
  std::vector<std::vector<float>> nodes_;
};

}  // namespace mien::render
