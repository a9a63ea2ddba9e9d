#include "motion/formats/bvh/bvh_rotation.h"

#include <array>
#include <cmath>

namespace mien::motion {

namespace {

constexpr std::array<Axis, 3> written_order = {Axis::z, Axis::x, Axis::y};

/// The angle plus the whole turns that bring it nearest to `previous`.
double continued(double angle, double previous) {
  return angle + 2.0 * pi * std::round((previous - angle) / (2.0 * pi));
}

Vec3 continued(const Vec3& angles, const Vec3& previous) {
  return {continued(angles[0], previous[0]), continued(angles[1], previous[1]),
          continued(angles[2], previous[2])};
}

}  // namespace

Vec3 bvh_angles(const Quat& rotation, const Vec3& previous) {
  const Vec3 angles = to_euler(written_order, rotation);
  const Vec3 one = continued(angles, previous);
  const Vec3 other = continued({angles[0] + pi, pi - angles[1], angles[2] + pi}, previous);
  return (one - previous).lpNorm<1>() <= (other - previous).lpNorm<1>() ? one : other;
}

Quat turned(const Quat& rotation, Axis axis, double degrees) {
  const double half = 0.5 * degrees * radians_per_degree;
  const double c = std::cos(half);
  const double s = std::sin(half);
  const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
  switch (axis) {
    case Axis::x:
      return {w * c - x * s, x * c + w * s, y * c + z * s, z * c - y * s};
    case Axis::y:
      return {w * c - y * s, x * c - z * s, y * c + w * s, z * c + x * s};
    case Axis::z:
      return {w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s};
  }
  return rotation;
}

}  // namespace mien::motion
