#pragma once

#include <cmath>

#include "motion/math/rotation.h"
#include "motion/skeleton/example.h"

namespace mien::test {

/// What sets one made-up walk apart from another. Radians, metres, seconds.
struct Gait {
  double duration = 1.1;
  double hip_swing = 0.4;
  double knee_bend = 0.9;
  double arm_swing = 0.35;
  double elbow_bend = 0.4;
  double lean = 0.05;
};

/// A walk in place of sinusoidal joint angles on the standard body: a motion to draw and measure,
/// not to admire. Loops; seven keytimes.
inline motion::Example walking_figure(const std::string& name, const Gait& gait, int frames = 33) {
  using namespace motion;
  Example example;
  example.name = name;
  example.clip.name = name;
  example.clip.body = standard_body();
  example.clip.frames_per_second = frames / gait.duration;
  example.clip.loops = true;
  const auto about_x = [](double angle) { return exp(Vec3(angle, 0, 0)); };
  for (int i = 0; i < frames; ++i) {
    const double cycle = 2 * pi * i / frames;
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    pose.root_position = Vec3(0.02 * std::sin(cycle), 0.93 + 0.02 * std::cos(2 * cycle), 0);
    pose.rotations[Pelvis] = exp(Vec3(0, 0.08 * std::cos(cycle), 0));
    pose.rotations[Spine] = about_x(gait.lean);
    for (const bool left : {true, false}) {
      const double phase = left ? cycle : cycle + pi;
      const int leg = left ? LeftHip : RightHip;
      const int arm = left ? LeftShoulder : RightShoulder;
      const double side = left ? 1.0 : -1.0;
      const auto at = [&](int joint) -> Quat& {
        return pose.rotations[static_cast<std::size_t>(joint)];
      };
      const double knee = gait.knee_bend * std::pow(0.5 - 0.5 * std::cos(phase + 0.9), 2.0);
      at(leg) = about_x(-gait.hip_swing * std::cos(phase) - 0.1 - 0.2 * knee);
      at(leg + 1) = about_x(0.1 + knee);
      at(leg + 2) = about_x(-0.05 + 0.25 * std::sin(phase));
      at(arm) = exp(Vec3(0, 0, -side * 1.45)) * exp(Vec3(0, 0, 0));
      at(arm) = about_x(gait.arm_swing * std::cos(phase)) * at(arm);
      at(arm + 1) = exp(Vec3(0, -side * gait.elbow_bend, 0));
    }
    example.clip.poses.push_back(pose);
  }
  for (const double share : {0.0, 0.12, 0.3, 0.5, 0.62, 0.8, 1.0}) {
    example.keytimes.push_back(share * example.clip.duration_seconds());
  }
  return example;
}

}  // namespace mien::test
