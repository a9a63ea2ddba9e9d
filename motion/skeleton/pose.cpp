#include "motion/skeleton/pose.h"

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

std::vector<Quat> interpolated(const std::vector<Quat>& from, const std::vector<Quat>& to,
                               double t) {
  std::vector<Quat> between(from.size());
  for (size_t j = 0; j < from.size(); ++j) between[j] = slerp(from[j], to[j], t);
  return between;
}

}  // namespace

JointTransform world_transform(const Skeleton& skeleton, const Pose& pose, int joint) {
  const auto at = static_cast<size_t>(joint);
  if (joint == 0) return {pose.root_position, pose.rotations[0]};
  const JointTransform parent = world_transform(skeleton, pose, skeleton.joints[at].parent);
  const Vec3& offset = pose.offsets.empty() ? skeleton.joints[at].offset : pose.offsets[at];
  return {parent.position + parent.rotation * offset, parent.rotation * pose.rotations[at]};
}

JointTransforms world_transforms(const Skeleton& skeleton, const Pose& pose) {
  const size_t count = skeleton.joints.size();
  JointTransforms world;
  world.positions.resize(count);
  world.rotations.resize(count);
  world.positions[0] = pose.root_position;
  world.rotations[0] = pose.rotations[0];
  for (size_t j = 1; j < count; ++j) {
    const Joint& joint = skeleton.joints[j];
    const auto parent = static_cast<size_t>(joint.parent);
    const Vec3& offset = pose.offsets.empty() ? joint.offset : pose.offsets[j];
    world.positions[j] = world.positions[parent] + world.rotations[parent] * offset;
    world.rotations[j] = world.rotations[parent] * pose.rotations[j];
  }
  return world;
}

std::vector<Vec3> world_positions(const Skeleton& skeleton, const Pose& pose) {
  return world_transforms(skeleton, pose).positions;
}

Pose interpolate(const Pose& from, const Pose& to, double t) {
  Pose pose;
  pose.root_position = (1.0 - t) * from.root_position + t * to.root_position;
  pose.rotations = interpolated(from.rotations, to.rotations, t);
  if (from.fingers.empty() || to.fingers.empty()) {
    pose.fingers = from.fingers.empty() ? to.fingers : from.fingers;
  } else {
    pose.fingers = interpolated(from.fingers, to.fingers, t);
  }
  if (!from.offsets.empty() && !to.offsets.empty()) {
    pose.offsets.resize(from.offsets.size());
    for (size_t j = 0; j < from.offsets.size(); ++j) {
      pose.offsets[j] = (1.0 - t) * from.offsets[j] + t * to.offsets[j];
    }
  }
  return pose;
}

}  // namespace mien::motion
