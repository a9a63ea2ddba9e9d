#include "scenes/skinning/dual_quaternion.h"

namespace mien::scenes {

using motion::Quat;
using motion::Vec3;

DualQuaternion dual_quaternion(const Quat& rotation, const Vec3& translation) {
  const Quat moved = Quat(0.0, translation.x(), translation.y(), translation.z()) * rotation;
  return {rotation.coeffs(), 0.5 * moved.coeffs()};
}

DualQuaternion normalized(const DualQuaternion& sum) {
  const double norm = sum.real.norm();
  const Eigen::Vector4d real = sum.real / norm;
  const Eigen::Vector4d dual = sum.dual / norm;
  return {real, dual - real.dot(dual) * real};
}

Quat rotation_of(const DualQuaternion& rigid) { return Quat(rigid.real); }

Vec3 translation_of(const DualQuaternion& rigid) {
  return 2.0 * (Quat(rigid.dual) * Quat(rigid.real).conjugate()).vec();
}

}  // namespace mien::scenes
