#include "pipeline/recording_clip.h"

#include "motion/rig/body_mapping.h"

namespace mien::pipeline {

namespace {

motion::Skeleton scaled(motion::Skeleton skeleton, double factor) {
  for (motion::Joint& joint : skeleton.joints) {
    joint.offset *= factor;
    if (joint.tip) *joint.tip *= factor;
  }
  return skeleton;
}

motion::Pose upright(motion::Pose pose, const motion::RigSketch& rig) {
  pose.root_position = rig.to_y_up * (pose.root_position * rig.metres_per_unit);
  pose.root_position.y() -= rig.floor;
  pose.rotations.front() = rig.to_y_up * pose.rotations.front();
  for (motion::Vec3& offset : pose.offsets) offset *= rig.metres_per_unit;
  return pose;
}

}  // namespace

motion::Clip clip_of(const motion::Recording& recording) {
  const motion::RigSketch rig = motion::sketch(recording);
  if (rig.human) return motion::to_body(recording, *rig.human);
  motion::Clip clip;
  clip.name = recording.name;
  clip.body = scaled(recording.skeleton, rig.metres_per_unit);
  clip.frames_per_second = recording.frames_per_second;
  for (const motion::Pose& pose : recording.poses) clip.poses.push_back(upright(pose, rig));
  return clip;
}

}  // namespace mien::pipeline
