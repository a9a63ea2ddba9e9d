#include "motion/skeleton/finger_angles.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mien::motion {

namespace {

/// Unit direction of a joint's bone at rest, in the joint's frame.
Vec3 bone_direction(int joint) {
  const bool is_last = segment_of(joint) == joints_per_finger - 1;
  const Vec3 bone = is_last ? fingertip_offset(is_left_finger(joint), finger_of(joint), 1.0)
                            : finger_offset(joint + 1, 1.0);
  return bone.normalized();
}

}  // namespace

FingerAngles finger_angles(const Pose& pose, int joint) {
  assert(pose.fingers.size() == finger_joint_count);
  const Vec3 straight = bone_direction(joint);
  const Vec3 axis = flexion_axis(joint);
  const Vec3 bent = pose.fingers[static_cast<size_t>(joint)].normalized() * straight;
  const double towards_palm = bent.dot(axis.cross(straight));
  return {std::atan2(towards_palm, bent.dot(straight)) / radians_per_degree,
          std::asin(std::clamp(bent.dot(axis), -1.0, 1.0)) / radians_per_degree};
}

FingerRanges finger_ranges(int joint) {
  constexpr FingerRange narrow = {-15, 15};
  constexpr FingerRange wide = {-80, 80};
  const int segment = segment_of(joint);
  if (finger_of(joint) == Finger::thumb) {
    if (segment == 0) return {wide, wide};
    if (segment == 1) return {{-20, 75}, wide};
    return {{-30, 95}, wide};
  }
  if (segment == 0) return {{-45, 95}, {-25, 25}};
  if (segment == 1) return {{-10, 115}, narrow};
  return {{-10, 90}, narrow};
}

}  // namespace mien::motion
