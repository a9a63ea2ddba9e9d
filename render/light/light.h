#pragma once

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

/// The part of a light above the floor: a polygon of five corners at most.
class FloorLight {
 public:
  explicit FloorLight(const AreaLight& light);

  int count() const { return count_; }
  const Vec3& corner(int i) const { return corners_[i]; }
  const Vec3& front() const { return front_; }  ///< normal of any length, on the side that emits
  const Vec3& centre() const { return centre_; }

 private:
  void add(const Vec3& corner) { corners_[count_++] = corner; }

  Vec3 corners_[5];
  int count_ = 0;
  Vec3 front_;
  Vec3 centre_;
};

/// Irradiance from the whole, unoccluded light, of radiance 1, at eight points of the floor:
/// Lambert's formula for polygons.
LaneFloats irradiance(const FloorLight& light, const LaneVectors& point);

}  // namespace mien::render
