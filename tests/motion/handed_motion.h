#pragma once

#include <cmath>
#include <random>

#include "motion/math/rotation.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/hand.h"

namespace mien::test {

/// Fingers that bend by smoothly changing angles, one whole number of times over the clip, so that
/// a loop of them closes.
inline motion::Clip with_moving_fingers(motion::Clip clip, std::mt19937_64& random) {
  using namespace motion;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Vec3> means, swings;
  std::vector<double> phases;
  for (int j = 0; j < finger_joint_count; ++j) {
    means.push_back(share(random) * flexion_axis(j));
    swings.push_back(0.3 * Vec3(share(random), share(random), share(random)));
    phases.push_back(2.0 * pi * share(random));
  }
  for (int f = 0; f < clip.frame_count(); ++f) {
    std::vector<Quat>& fingers = clip.poses[size_t(f)].fingers;
    fingers.resize(finger_joint_count);
    const double turn = 2.0 * pi * f / clip.frame_count();
    for (size_t j = 0; j < fingers.size(); ++j)
      fingers[j] = exp(means[j]) * exp(std::sin(turn + phases[j]) * swings[j]);
  }
  return clip;
}

/// The largest angle between corresponding finger joints, radians.
inline double largest_finger_turn(const motion::Pose& a, const motion::Pose& b) {
  double largest = 0.0;
  for (size_t j = 0; j < a.fingers.size(); ++j)
    largest = std::max(largest, motion::angle_between(a.fingers[j], b.fingers[j]));
  return largest;
}

}  // namespace mien::test
