#include "motion/skeleton/joint_transform.h"

namespace mien::motion {

JointTransform world_transform(const Skeleton& skeleton, const Pose& pose, int joint) {
  const auto at = static_cast<size_t>(joint);
  if (joint == 0) return {pose.root_position, pose.rotations[0]};
  const JointTransform parent = world_transform(skeleton, pose, skeleton.joints[at].parent);
  const Vec3& offset = pose.offsets.empty() ? skeleton.joints[at].offset : pose.offsets[at];
  return {parent.position + parent.rotation * offset, parent.rotation * pose.rotations[at]};
}

}  // namespace mien::motion
