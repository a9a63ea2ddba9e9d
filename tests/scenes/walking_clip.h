#pragma once

#include <cmath>

#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip.h"

namespace mien::scenes::test {

/// A body that goes along a direction, legs swinging once a second, arms held out and still; 30
/// frames a second.
inline motion::Clip walking_clip(int frames, const motion::Vec3& direction, double metres_a_frame) {
  motion::Clip clip;
  clip.body = motion::standard_body();
  const motion::Quat facing = motion::turn_between(motion::Vec3::UnitZ(), direction);
  for (int f = 0; f < frames; ++f) {
    const double swing = 0.6 * std::sin(2.0 * motion::pi * f / 30.0);
    motion::Pose pose;
    pose.rotations.assign(motion::body_joint_count, motion::Quat::Identity());
    pose.rotations[motion::Pelvis] = facing;
    const auto turn = [&](motion::BodyJoint joint, double angle) {
      pose.rotations[joint] = motion::Quat(Eigen::AngleAxisd(angle, motion::Vec3::UnitX()));
    };
    turn(motion::LeftHip, -swing);
    turn(motion::RightHip, swing);
    turn(motion::LeftKnee, 0.4 + 0.4 * swing);
    turn(motion::RightKnee, 0.4 - 0.4 * swing);
    pose.root_position = motion::Vec3(0.4, 0.95, -0.7) + f * metres_a_frame * direction;
    clip.poses.push_back(pose);
  }
  return clip;
}

}  // namespace mien::scenes::test
