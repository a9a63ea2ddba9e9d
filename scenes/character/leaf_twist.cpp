#include "scenes/character/leaf_twist.h"

#include <algorithm>

#include "motion/math/rotation.h"

namespace mien::scenes {

double max_twist(motion::BodyJoint joint) {
  constexpr double degree = motion::radians_per_degree;
  if (joint == motion::LeftToe || joint == motion::RightToe) return 30.0 * degree;
  for (const auto end : {motion::Head, motion::LeftWrist, motion::RightWrist})
    if (joint == end) return 110.0 * degree;
  return motion::pi;
}

motion::Quat clamped_twist(const motion::Quat& rotation, const motion::Vec3& axis, double most) {
  const motion::Quat twist = motion::twist_about(rotation, axis);
  const double angle = motion::log(twist).dot(axis);
  const double less = std::clamp(angle, -most, most);
  if (less == angle) return rotation;
  return rotation * twist.conjugate() * motion::exp(less * axis);
}

}  // namespace mien::scenes
