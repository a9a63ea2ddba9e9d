#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "motion/math/geometry.h"
#include "motion/skeleton/hand.h"

namespace mien::test {

/// Fingers of which each joint is bent by `degrees_of(joint)`.
template <class DegreesOf>
std::vector<motion::Quat> bent_fingers(const DegreesOf& degrees_of) {
  std::vector<motion::Quat> fingers;
  for (int joint = 0; joint < motion::finger_joint_count; ++joint) {
    fingers.emplace_back(Eigen::AngleAxisd(degrees_of(joint) * motion::radians_per_degree,
                                           motion::flexion_axis(joint)));
  }
  return fingers;
}

/// Fingers of which each joint is bent at random, by what human fingers can.
inline std::vector<motion::Quat> random_fingers(std::uint32_t seed) {
  std::mt19937 random(seed);
  return bent_fingers([&](int joint) {
    const bool is_thumb = motion::finger_of(joint) == motion::Finger::thumb;
    return std::uniform_real_distribution<double>(-10.0, is_thumb ? 50.0 : 95.0)(random);
  });
}

}  // namespace mien::test
