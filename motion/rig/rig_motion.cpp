#include "motion/rig/rig_motion.h"

#include <cassert>

#include "motion/math/rotation.h"
#include "motion/rig/joint_word.h"

namespace mien::motion {

namespace {

std::optional<BodyJoint> main_child(BodyJoint joint) {
  for (const BodyJoint tip : {Head, LeftWrist, RightWrist, LeftToe, RightToe})
    if (joint == tip) return std::nullopt;
  return BodyJoint(joint + 1);  // joints are numbered down each chain
}

/// Eyes, jaw and the like, with what hangs on them.
std::vector<bool> joints_of_face(const Skeleton& rig) {
  std::vector<bool> in_face(static_cast<size_t>(rig.size()), false);
  for (int j = 0; j < rig.size(); ++j) {
    const auto index = static_cast<size_t>(j);
    const int parent = rig.joints[index].parent;
    in_face[index] = names_a_part_of_the_face(rig.joints[index].name) ||
                     (parent >= 0 && in_face[static_cast<size_t>(parent)]);
  }
  return in_face;
}

}  // namespace

std::vector<JointTransforms> world_frames(const Recording& recording) {
  std::vector<JointTransforms> world;
  world.reserve(recording.poses.size());
  for (const Pose& pose : recording.poses) {
    world.push_back(world_transforms(recording.skeleton, pose));
  }
  return world;
}

Vec3 RigMotion::point(const JointTransforms& frame, BodyJoint joint) const {
  assert(has(joint));
  const MappedJoint& mapped = joints[joint];
  const Vec3& position = frame.positions[mapped.position];
  if (!mapped.at_tip) return position;
  return position + frame.rotations[mapped.position] * *rig.joints[mapped.position].tip;
}

const Quat& RigMotion::rotation(const JointTransforms& frame, BodyJoint joint) const {
  assert(turns(joint));
  return frame.rotations[joints[joint].rotation()];
}

RigMotion rig_motion(const Recording& recording, const MappedJoints& joints, const Quat& to_y_up) {
  RigMotion motion{recording.skeleton, joints, world_frames(recording),
                   recording.frames_per_second};
  for (JointTransforms& frame : motion.frames) {
    for (Vec3& position : frame.positions) position = to_y_up * position;
    for (Quat& rotation : frame.rotations) rotation = to_y_up * rotation;
  }
  return motion;
}

JointTransforms zero_pose(const Skeleton& rig) {
  Pose pose;
  pose.rotations.assign(rig.joints.size(), Quat::Identity());
  return world_transforms(rig, pose);
}

double leg_length(const RigMotion& motion) {
  double sum = 0.0;
  for (const JointTransforms& frame : motion.frames) {
    for (const BodyJoint hip : {LeftHip, RightHip}) {
      const auto knee = BodyJoint(hip + 1);
      const auto ankle = BodyJoint(hip + 2);
      sum += (motion.point(frame, knee) - motion.point(frame, hip)).norm() +
             (motion.point(frame, ankle) - motion.point(frame, knee)).norm();
    }
  }
  return 0.5 * sum / static_cast<double>(motion.frames.size());
}

std::optional<BodyJoint> next_present(const RigMotion& motion, BodyJoint joint) {
  std::optional<BodyJoint> next = main_child(joint);
  while (next && !motion.has(*next)) next = main_child(*next);
  return next;
}

Vec3 far_end(const RigMotion& motion, BodyJoint joint) {
  const int top = motion.joints[joint].rotation();
  const std::vector<bool> is_in_face = joints_of_face(motion.rig);
  Vec3 farthest = Vec3::Zero();
  const auto consider = [&](const Vec3& end) {
    if (end.norm() > farthest.norm()) farthest = end;
  };
  for (int j = top; j < motion.rig.size(); ++j) {
    if (is_in_face[static_cast<size_t>(j)] || common_ancestor(motion.rig, top, j) != top) continue;
    const Vec3 tip = motion.rig.joints[j].tip.value_or(Vec3::Zero());
    Vec3 mean = Vec3::Zero();
    for (const JointTransforms& frame : motion.frames) {
      const Vec3 end = frame.positions[j] + frame.rotations[j] * tip;
      mean += frame.rotations[top].conjugate() * (end - frame.positions[top]);
    }
    consider(mean / static_cast<double>(motion.frames.size()));
  }
  return farthest;
}

UpAxis up_axis(const std::vector<JointTransforms>& world, const MappedJoints& joints) {
  Vec3 sum = Vec3::Zero();
  for (const JointTransforms& frame : world) {
    const auto at = [&](BodyJoint joint) { return frame.positions[joints[joint].position]; };
    const BodyJoint top = joints[Chest].position >= 0 ? Chest : LeftShoulder;
    const Vec3 feet = 0.5 * (at(LeftAnkle) + at(RightAnkle));
    sum += (at(top) - feet).normalized();
  }
  sum /= static_cast<double>(world.size());
  int largest = 0;
  sum.cwiseAbs().maxCoeff(&largest);
  return {Vec3::Unit(largest) * (sum[largest] < 0 ? -1.0 : 1.0), std::abs(sum[largest])};
}

Quat turn_to_y_up(const Vec3& axis) {
  if (axis.y() < -0.5) return Quat(0.0, 1.0, 0.0, 0.0);
  return turn_between(axis, Vec3::UnitY());
}

}  // namespace mien::motion
