#include "motion/math/rotation.h"

#include <algorithm>
#include <cmath>

#include "motion/math/singular_values.h"

namespace mien::motion {

Vec3 log(const Quat& rotation) {
  const Quat q = rotation.w() < 0 ? Quat(-rotation.coeffs()) : rotation;
  const double s = q.vec().norm();
  // sin(x)/x ≈ 1 − x²/6: below this s the quotient 2·atan2(s, w)/s is 2 to machine precision.
  if (s < 1e-9) return 2.0 * q.vec();
  return q.vec() * (2.0 * std::atan2(s, q.w()) / s);
}

Quat exp(const Vec3& rotation_vector) {
  const double half = 0.5 * rotation_vector.norm();
  if (half < 1e-9) {
    return Quat(1.0, 0.5 * rotation_vector.x(), 0.5 * rotation_vector.y(),
                0.5 * rotation_vector.z())
        .normalized();
  }
  const Vec3 v = rotation_vector * (0.5 * std::sin(half) / half);
  return Quat(std::cos(half), v.x(), v.y(), v.z());
}

double angle_between(const Quat& from, const Quat& to) { return log(from.conjugate() * to).norm(); }

Quat slerp(const Quat& from, const Quat& to, double t) {
  if (t <= 0.0) return from;
  if (t >= 1.0) return in_hemisphere_of(from, to);
  return from * exp(t * log(from.conjugate() * to));
}

Quat in_hemisphere_of(const Quat& reference, const Quat& rotation) {
  return reference.dot(rotation) < 0 ? Quat(-rotation.coeffs()) : rotation;
}

// As Eigen's FromTwoVectors, whose own matrices take ten seconds to compile.
Quat turn_between(const Vec3& from, const Vec3& to) {
  const Vec3 a = from.normalized();
  const Vec3 b = to.normalized();
  const double cosine = b.dot(a);
  Quat turn;
  if (cosine < -1.0 + Eigen::NumTraits<double>::dummy_precision()) {
    const double half = 0.5 * (1.0 + std::max(cosine, -1.0));
    turn.w() = std::sqrt(half);
    turn.vec() = perpendicular_to(a, b) * std::sqrt(1.0 - half);
    return turn;
  }
  const double twice = std::sqrt(2.0 * (1.0 + cosine));
  turn.w() = 0.5 * twice;
  turn.vec() = a.cross(b) * (1.0 / twice);
  return turn;
}

Quat heading(const Vec3& direction) {
  if (std::hypot(direction.x(), direction.z()) < 1e-12) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(std::atan2(direction.x(), direction.z()), Vec3::UnitY()));
}

Quat twist_about(const Quat& rotation, const Vec3& axis) {
  const double along = rotation.vec().dot(axis);
  const double norm = std::hypot(rotation.w(), along);
  if (norm < 1e-12) return Quat::Identity();
  const Vec3 v = axis * (along / norm);
  return Quat(rotation.w() / norm, v.x(), v.y(), v.z());
}

Quat frame_from(const Vec3& x, const Vec3& y_hint) {
  Mat3 frame;
  frame.col(0) = x.normalized();
  frame.col(2) = frame.col(0).cross(y_hint).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return Quat(frame).normalized();
}

Vec3 to_euler(const std::array<Axis, 3>& order, const Quat& rotation) {
  const int i = static_cast<int>(order[0]);
  const int j = static_cast<int>(order[1]);
  const int k = static_cast<int>(order[2]);
  const double sign = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;  // even or odd permutation of x, y, z
  const Mat3 m = rotation.toRotationMatrix();
  const double sin_middle = sign * m(i, k);
  const double cos_middle = std::hypot(m(i, i), m(i, j));
  const double middle = std::atan2(sin_middle, cos_middle);
  if (cos_middle < 1e-9) {
    return {std::atan2(sign * m(k, j), m(j, j)), middle, 0.0};
  }
  return {std::atan2(-sign * m(j, k), m(k, k)), middle, std::atan2(-sign * m(i, j), m(i, i))};
}

DirectionVectors to_direction_vectors(const Quat& rotation) {
  const Mat3 m = rotation.toRotationMatrix();
  return {m.col(0), m.col(1)};
}

Quat to_rotation(const DirectionVectors& directions, const Quat& previous) {
  const Mat3 before = previous.toRotationMatrix();
  const double length = directions.d1.norm();
  const Vec3 x = length < 0.05 ? Vec3(before.col(0)) : Vec3(directions.d1 / length);
  Vec3 z = x.cross(directions.d2);
  if (z.norm() < 0.05 * directions.d2.norm() || z.norm() < 1e-12) {
    z = before.col(2) - before.col(2).dot(x) * x;
    if (z.norm() < 1e-6) z = x.unitOrthogonal();
  }
  z.normalize();
  Mat3 m;
  m.col(0) = x;
  m.col(1) = z.cross(x);
  m.col(2) = z;
  return in_hemisphere_of(previous, Quat(m).normalized());
}

}  // namespace mien::motion
