#pragma once

#include <cmath>
#include <functional>

#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

/// A standing figure reaches out with its right arm and comes back, `reaches` times: the shoulder
/// swings forward by up to `radians` and the elbow by half as much. `pace` maps the share of each
/// reach's time to the share of its way.
inline motion::Clip reach(
    double seconds, double radians, int reaches = 1,
    const std::function<double(double)>& pace = [](double t) { return t; }, double fps = 60.0) {
  using namespace motion;
  Clip clip;
  clip.name = "reach";
  clip.body = standard_body();
  clip.frames_per_second = fps;
  const int frames = static_cast<int>(std::lround(reaches * seconds * fps)) + 1;
  for (int i = 0; i < frames; ++i) {
    const double time = static_cast<double>(i) / (frames - 1) * reaches;
    const double phase = time - std::floor(time);
    const double out = 0.5 - 0.5 * std::cos(2.0 * pi * pace(phase));
    Pose pose;
    pose.root_position = Vec3(0, 0.95, 0);
    pose.rotations.assign(body_joint_count, Quat::Identity());
    const auto about = [](const Vec3& axis, double angle) {
      return Quat(Eigen::AngleAxisd(angle, axis));
    };
    pose.rotations[RightShoulder] =
        about(Vec3::UnitX(), -radians * out) * about(Vec3::UnitZ(), 1.45);
    pose.rotations[RightElbow] = about(Vec3::UnitY(), 0.5 * radians * out);
    clip.poses.push_back(pose);
  }
  return clip;
}

}  // namespace mien::test
