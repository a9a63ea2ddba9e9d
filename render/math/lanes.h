#pragma once

#include <cstdint>

#include "render/math/vector.h"

namespace mien::render {

// Arithmetic on eight samples at a time, as arrays of eight. Unused lanes may hold any finite
// values. Results are bit-identical on every machine.

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

/// Points of the unit square.
struct LanePoints {
  LaneFloats u;
  LaneFloats v;
};

/// `sample_point` (sampler.h) for eight indices and seeds.
LanePoints sample_points(const LaneWords& index, const LaneWords& seed);

/// Unit directions about unit normals with density cos θ / π.
LaneVectors cosine_directions(const LaneVectors& normal, const LanePoints& u);

/// Rays that sample what a sphere contains: uniform in the cone of directions from each point to
/// the sphere or, where that would be wide (`greatest_cone_sine_squared`), cosine-distributed about
/// the unit normal there. `share` is cos θ / π over the density: the share that a ray represents of
/// the irradiance from surroundings of even radiance. It is 0 or less for rays that leave the
/// surface on the wrong side.
struct LaneSphereRays {
  LaneVectors towards;
  LaneFloats share;
};
LaneSphereRays rays_to_sphere(const Vec3& centre, float radius, const LaneVectors& point,
                              const LaneVectors& normal, const LanePoints& u);

/// Squared sine of the half angle (about 51°) at and above which a cone counts as wide.
inline constexpr float greatest_cone_sine_squared = 0.6f;

}  // namespace mien::render
