#include "motion/fitting/rigid_placement.h"

#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

}  // namespace

std::optional<Placement> rigid_placement(std::span<const Vec3> shape,
                                         std::span<const Vec3> measured) {
  if (shape.size() < 3 || shape.size() != measured.size()) return std::nullopt;
  const Vec3 shape_mean = mean_of(shape);
  const Vec3 measured_mean = mean_of(measured);
  Mat3 covariance = Mat3::Zero();
  for (std::size_t i = 0; i < shape.size(); ++i) {
    covariance += (measured[i] - measured_mean) * (shape[i] - shape_mean).transpose();
  }
  const SingularValues parts = singular_values(covariance);
  // A second value this small beside the first: the points lie within a fifth of a line's length.
  if (parts.values(1) < 0.02 * parts.values(0)) return std::nullopt;
  const Mat3 u = parts.u;
  const Mat3 v = parts.v;
  Mat3 sign = Mat3::Identity();
  if ((u * v.transpose()).determinant() < 0.0) sign(2, 2) = -1.0;
  const Mat3 turn = u * sign * v.transpose();
  const Quat rotation = Quat(turn).normalized();
  return Placement{rotation, measured_mean - rotation * shape_mean};
}

}  // namespace mien::motion
