#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "motion/skeleton/pose.h"
#include "motion/skeleton/recording.h"

namespace mien::test {

/// A file's text with its first `from` as `to`.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

inline void expect_near(const motion::Vec3& a, const motion::Vec3& b, double tolerance = 1e-12) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << " is not " << b.transpose();
}

/// Where the tip of a joint without children is, metres.
inline motion::Vec3 tip_at(const motion::Recording& recording, size_t frame, size_t joint) {
  const motion::JointTransforms world =
      motion::world_transforms(recording.skeleton, recording.poses[frame]);
  return world.positions[joint] + world.rotations[joint] * *recording.skeleton.joints[joint].tip;
}

}  // namespace mien::test
