#pragma once

#include <cmath>
#include <functional>

#include "motion/math/rotation.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

/// A standing body whose arms are turned at the shoulders, as functions of time, from the T-pose;
/// 4 s long.
inline motion::Clip arm_motion(double frames_per_second,
                               const std::function<motion::Quat(double)>& left_shoulder,
                               const std::function<motion::Quat(double)>& right_shoulder) {
  using namespace motion;
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = frames_per_second;
  const int frames = static_cast<int>(4.0 * frames_per_second);
  for (int f = 0; f < frames; ++f) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = {0.0, 0.95, 0.0};
    pose.rotations[LeftShoulder] = left_shoulder(f / frames_per_second);
    pose.rotations[RightShoulder] = right_shoulder(f / frames_per_second);
    clip.poses.push_back(pose);
  }
  return clip;
}

/// Bounces off 0 abruptly, `rate` times a second, else as smooth as a sine; at most 1.
inline double bounce(double seconds, double rate) {
  return std::abs(std::sin(motion::pi * rate * seconds));
}

inline motion::Quat about(const motion::Vec3& axis, double degrees) {
  return motion::exp(axis * (degrees * motion::radians_per_degree));
}

/// The arm forward and, from there, down and away from the midline by these angles.
inline motion::Quat forward_arm(bool left, double down, double outwards) {
  const double side = left ? 1.0 : -1.0;
  return about(motion::Vec3::UnitX(), down) *
         about(motion::Vec3::UnitY(), side * (outwards - 90.0));
}

/// Both hands meet in front of the chest twice a second.
inline motion::Clip clapping(double frames_per_second) {
  return arm_motion(
      frames_per_second,
      [](double t) { return forward_arm(true, 10.0, -14.0 + 25.0 * bounce(t, 2.0)); },
      [](double t) { return forward_arm(false, 10.0, -14.0 + 25.0 * bounce(t, 2.0)); });
}

/// The left hand hits a table twice a second; the right arm hangs.
inline motion::Clip drumming(double frames_per_second) {
  return arm_motion(
      frames_per_second,
      [](double t) { return forward_arm(true, 40.0 - 25.0 * bounce(t, 2.0), 5.0); },
      [](double) { return about(motion::Vec3::UnitZ(), 80.0); });
}

/// The raised left hand waves sideways, back and forth in half a second.
inline motion::Clip waving(double frames_per_second) {
  return arm_motion(
      frames_per_second,
      [](double t) {
        return about(motion::Vec3::UnitZ(), 70.0 + 18.0 * std::sin(4.0 * motion::pi * t));
      },
      [](double) { return about(motion::Vec3::UnitZ(), 80.0); });
}

}  // namespace mien::test
