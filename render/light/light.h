#pragma once

#include <vector>

#include "render/math/lanes.h"
#include "render/scene/scene.h"

namespace mien::render {

/// For each of eight points, a point chosen on a light, as seen from it.
struct LaneLights {
  LaneVectors towards;  ///< unit
  LaneFloats distance;  ///< metres
  /// Solid angle that the sample represents, steradians; 0 behind the light. Multiplied by the
  /// light's radiance it gives the irradiance of a surface that faces the sample.
  LaneFloats share;
};

/// Samples the light uniformly by area: E[share · cos θ] · radiance is the irradiance.
LaneLights sample(const AreaLight& light, const LaneVectors& point, const LanePoints& u);

/// The part of a light above the floor, a polygon.
struct FloorLight {
  explicit FloorLight(const AreaLight& light);

  std::vector<Vec3> corners;
  Vec3 front;   ///< normal of any length, on the side that emits
  Vec3 centre;  ///< of the whole light
};

/// All numbers that a light consists of.
std::vector<float> numbers_of(const AreaLight& light);

/// Irradiance from the whole, unoccluded light, of radiance 1, at eight points of the floor:
/// Lambert's formula for polygons.
LaneFloats irradiance(const FloorLight& light, const LaneVectors& point);

}  // namespace mien::render
