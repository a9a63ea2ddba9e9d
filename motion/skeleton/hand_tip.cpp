#include "motion/skeleton/hand_tip.h"

#include "motion/skeleton/body.h"

namespace mien::motion {

double hand_length(const Skeleton& body) { return 0.108 * 1.75 * relative_stature(body); }

Vec3 hand_vector(const Skeleton& body, const Pose& pose, bool left) {
  const BodyJoint wrist = left ? LeftWrist : RightWrist;
  return world_transform(body, pose, wrist).rotation * rest_direction(wrist) * hand_length(body);
}

Vec3 hand_tip(const Skeleton& body, const Pose& pose, bool left) {
  return world_transform(body, pose, left ? LeftWrist : RightWrist).position +
         hand_vector(body, pose, left);
}

}  // namespace mien::motion
