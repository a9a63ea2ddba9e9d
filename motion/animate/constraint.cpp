#include "motion/animate/constraint.h"

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// A component of the rotation vector of one joint, or of a pair of joints together.
struct AngleTraits {
  BodyJoint lower, upper;  ///< the same for a single joint
  int axis;
  double sign;
};

constexpr std::array<AngleTraits, 8> angle_traits = {{{Neck, Head, 0, 1.0},
                                                      {Neck, Head, 2, -1.0},
                                                      {Neck, Head, 1, 1.0},
                                                      {Spine, Chest, 0, 1.0},
                                                      {Spine, Chest, 2, -1.0},
                                                      {Spine, Chest, 1, 1.0},
                                                      {LeftElbow, LeftElbow, 1, -1.0},
                                                      {RightElbow, RightElbow, 1, 1.0}}};

const AngleTraits& angle_traits_of(RangeAngle angle) {
  return angle_traits[static_cast<std::size_t>(angle)];
}

Quat whole_of(const Pose& pose, const AngleTraits& angle) {
  if (angle.lower == angle.upper) return pose.rotations[angle.lower];
  return pose.rotations[angle.lower] * pose.rotations[angle.upper];
}

}  // namespace

double angle_of(const Pose& pose, RangeAngle angle) {
  const AngleTraits& own = angle_traits_of(angle);
  return own.sign * log(whole_of(pose, own))[own.axis];
}

Pose with_angle(const Pose& pose, RangeAngle angle, double radians) {
  const AngleTraits& own = angle_traits_of(angle);
  const Quat before = whole_of(pose, own);
  Vec3 vector = log(before);
  vector[own.axis] = own.sign * radians;
  const Quat after = exp(vector);
  Pose result = pose;
  Quat& upper = result.rotations[own.upper];
  if (own.lower == own.upper) {
    upper = in_hemisphere_of(upper, after);
    return result;
  }
  Quat& lower = result.rotations[own.lower];
  const Quat turned = exp(0.5 * log(after * before.conjugate())) * lower;
  lower = in_hemisphere_of(lower, turned.normalized());
  upper = in_hemisphere_of(upper, (turned.conjugate() * after).normalized());
  return result;
}

}  // namespace mien::motion
