#include "scenes/character/leaf_twist.h"

#include <algorithm>

#include "motion/math/rotation.h"

namespace mien::scenes {

double max_twist(motion::BodyJoint joint) {
  constexpr double degree = motion::radians_per_degree;
  switch (joint) {
    case motion::LeftToe:
    case motion::RightToe:
      return 30.0 * degree;
    case motion::Head:
    case motion::LeftWrist:
    case motion::RightWrist:
      return 110.0 * degree;
    default:
      return motion::pi;
  }
}

motion::Quat clamped_twist(const motion::Quat& rotation, const motion::Vec3& axis, double most) {
  const motion::Quat twist = motion::twist_about(rotation, axis);
  const double angle = motion::log(twist).dot(axis);
  const double less = std::clamp(angle, -most, most);
  if (less == angle) return rotation;
  return rotation * twist.conjugate() * motion::exp(less * axis);
}

}  // namespace mien::scenes
