#include "motion/skeleton/mirror.h"

#include "motion/skeleton/clip_markers.h"
#include "motion/skeleton/hand.h"

namespace mien::motion {

namespace {

Quat mirrored(const Quat& q) { return {q.w(), q.x(), -q.y(), -q.z()}; }

}  // namespace

Pose mirrored(const Pose& pose) {
  Pose result = pose;
  result.root_position = mirrored_place(pose.root_position);
  for (int j = 0; j < body_joint_count; ++j) {
    result.rotations[j] = mirrored(pose.rotations[mirrored(BodyJoint(j))]);
  }
  for (size_t j = 0; j < pose.fingers.size(); ++j) {
    const auto other = static_cast<size_t>(mirrored_finger(static_cast<int>(j)));
    result.fingers[j] = mirrored(pose.fingers[other]);
  }
  return result;
}

Clip mirrored(const Clip& clip) {
  Clip result = clip;
  for (int j = 0; j < body_joint_count; ++j) {
    const Joint& other = clip.body.joints[mirrored(BodyJoint(j))];
    result.body.joints[j].offset = mirrored_place(other.offset);
    result.body.joints[j].tip = other.tip;
    if (other.tip) result.body.joints[j].tip = mirrored_place(*other.tip);
  }
  for (Pose& pose : result.poses) pose = mirrored(pose);
  result.cycle_displacement = mirrored_place(clip.cycle_displacement);
  carry_markers(clip, result, [](int, const Vec3& place) { return mirrored_place(place); });
  if (const Markers* markers = markers_of(result)) attach(result, with_sides_exchanged(*markers));
  return result;
}

}  // namespace mien::motion
