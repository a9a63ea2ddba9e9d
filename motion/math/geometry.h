#pragma once

#include <algorithm>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace mien::motion {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double radians_per_degree = pi / 180.0;

/// The vector with its y component (height) set to 0.
inline Vec3 horizontal(const Vec3& v) { return {v.x(), 0.0, v.z()}; }

/// Smooth step from 0 (x ≤ 0) to 1 (x ≥ 1), with zero slope at both ends. For a falling step see
/// fade (filter.h).
inline double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace mien::motion
