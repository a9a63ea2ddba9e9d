#include "motion/rig/recording_clip.h"

#include "motion/rig/body_mapping.h"

namespace mien::motion {

namespace {

Skeleton scaled(Skeleton skeleton, double factor) {
  for (Joint& joint : skeleton.joints) {
    joint.offset *= factor;
    if (joint.tip) *joint.tip *= factor;
  }
  return skeleton;
}

Pose upright(Pose pose, const RigAnalysis& rig) {
  pose.root_position = rig.to_y_up * (pose.root_position * rig.metres_per_unit);
  pose.root_position.y() -= rig.floor;
  pose.rotations.front() = rig.to_y_up * pose.rotations.front();
  for (Vec3& offset : pose.offsets) offset *= rig.metres_per_unit;
  return pose;
}

}  // namespace

Recording in_metres(Recording recording) {
  const RigAnalysis rig = analyse_rig(recording);
  if (!rig.human) return recording;  // nothing tells its unit and axes
  const double unit = rig.metres_per_unit;
  for (Joint& joint : recording.skeleton.joints) {
    joint.offset *= unit;
    if (joint.tip) *joint.tip *= unit;
  }
  for (Pose& pose : recording.poses) {
    pose.root_position = rig.to_y_up * (unit * pose.root_position);
    pose.rotations.front() = rig.to_y_up * pose.rotations.front();
    for (Vec3& offset : pose.offsets) offset *= unit;
  }
  return recording;
}

Clip clip_of(const Recording& recording) {
  const RigAnalysis rig = analyse_rig(recording);
  if (rig.human) return to_body(recording, *rig.human);
  Clip clip;
  clip.name = recording.name;
  clip.body = scaled(recording.skeleton, rig.metres_per_unit);
  clip.frames_per_second = recording.frames_per_second;
  for (const Pose& pose : recording.poses) clip.poses.push_back(upright(pose, rig));
  return clip;
}

}  // namespace mien::motion
