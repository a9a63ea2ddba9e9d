#pragma once

#include <vector>

#include "render/math/vector.h"
#include "render/scene/scene.h"

namespace mien::render {

/// A sphere or round cone prepared for intersection tests: the convex hull of two spheres, a and b.
struct PreparedCone {
  Vec3 a = Vec3::Zero();
  Vec3 axis = Vec3::Zero();  ///< from a to b; zero for a sphere
  float radius_a = 0.0f;
  float radius_b = 0.0f;
  float axis_squared = 0.0f;  ///< |axis|²
  float slope = 0.0f;         ///< radius_a − radius_b
  float side_squared = 0.0f;  ///< |axis|² − slope²: squared length of the side; zero for a sphere
  int material = 0;
  int part = 0;

  Vec3 b() const { return a + axis; }
};

PreparedCone prepared_cone(const Sphere& sphere);
PreparedCone prepared_cone(const RoundCone& round_cone);

/// All spheres, then all round cones.
std::vector<PreparedCone> prepared_cones(const Solids& solids);

/// Unit outward normal at a point of the surface.
Vec3 normal_at(const PreparedCone& cone, const Vec3& point);

/// Rays as arrays, one value per lane; directions have unit length.
struct RayLanes {
  const float* origin_x;
  const float* origin_y;
  const float* origin_z;
  const float* direction_x;
  const float* direction_y;
  const float* direction_z;
};

inline constexpr unsigned max_lanes = 16;

/// Writes the distances along each of `count` ≤ max_lanes rays at which its line enters and leaves
/// the solid; enter > leave when it misses. Results are bit-identical on every machine.
///
/// The solid is convex and is the union of both spheres and the hull between them, so the interval
/// is bounded by the extreme roots of the three surfaces; only for roots of the (double) cone must
/// it be tested that they lie on the hull's side. Roots are computed relative to the point of the
/// line nearest to the solid's centre, which keeps them accurate for distant ray origins. The round
/// cone's quadratic is that of Quilez (2018).
void intersect_lines(const PreparedCone& cone, const RayLanes& rays, unsigned count, float* enter,
                     float* leave);

/// Writes, for each line, `enter` if it exceeds `from`, otherwise `leave` if that does; infinity if
/// neither does or the line misses.
void crossings_beyond(const float* from, const float* enter, const float* leave, unsigned count,
                      float* distance);

}  // namespace mien::render
