#pragma once

#include <cstdint>

#include "render/math/filter.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"

namespace mien::render {

// Arithmetic on eight samples at a time, as arrays of eight: the counterparts of the scalar
// functions of sampler.h, directions.h, light.h and camera.h. Unused lanes may hold any finite
// values. Results are bit-identical on every machine and equal the scalar ones up to rounding.

inline constexpr unsigned lanes = 8;

struct LaneFloats {
  alignas(32) float lane[lanes] = {};

  float& operator[](int i) { return lane[i]; }
  const float& operator[](int i) const { return lane[i]; }
};

struct LaneWords {
  alignas(32) std::uint32_t lane[lanes] = {};

  std::uint32_t& operator[](int i) { return lane[i]; }
  const std::uint32_t& operator[](int i) const { return lane[i]; }
};

struct LaneVectors {
  LaneFloats x;
  LaneFloats y;
  LaneFloats z;

  Vec3 at(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3& v) {
    x[i] = v.x();
    y[i] = v.y();
    z[i] = v.z();
  }
};

struct LanePoints {
  LaneFloats u;
  LaneFloats v;
};

/// `sample_point` (sampler.h) for eight indices and seeds.
LanePoints sample_points(const LaneWords& index, const LaneWords& seed);

/// Camera rays through eight points of the image plane (the filter's offset already added), of a
/// pinhole or orthographic camera. The origins are the camera's position unless it is orthographic.
void camera_rays(const CameraFrame& camera, const LaneFloats& x, const LaneFloats& y,
                 LaneVectors& origin, LaneVectors& direction);

/// `cosine_direction` (directions.h) about eight normals.
LaneVectors cosine_directions(const LaneVectors& normal, const LanePoints& u);

/// `cone_direction` (directions.h) about one axis, for eight random points.
LaneVectors cone_directions(const Vec3& axis, float cosine_of_half_angle, const LanePoints& u);

/// `sample` (light.h) of one light from eight points.
struct LaneLights {
  LaneVectors towards;
  LaneFloats distance;
  LaneFloats share;  ///< solid angle that the sample represents, steradians; times the light's
                     ///< radiance it is LightSample::perpendicular
};
LaneLights sample_lights(const AreaLight& light, const LaneVectors& point, const LanePoints& u);

/// The part of a light above the floor: a polygon of five corners at most, in the order in which
/// `irradiance` traverses them.
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

/// `irradiance` (light.h) from a light of radiance 1 on eight points of the floor.
LaneFloats light_on_floor(const FloorLight& light, const LaneVectors& point);

/// Rays from eight points of the floor that sample how the contents of a bounding sphere occlude
/// the sky: uniform in the cone around it (cone_of), or cosine-distributed where it fills too much
/// of the sky. `share` is the fraction of a uniform sky's light that each represents.
struct LaneSkyRays {
  LaneVectors towards;
  LaneFloats share;
};
LaneSkyRays floor_sky_rays(const Vec3& centre, float radius, const LaneVectors& point,
                           const LanePoints& u);

}  // namespace mien::render
