#include "motion/skeleton/mirror.h"

#include <gtest/gtest.h>

#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Mirror, ShowsEveryJointOnTheOtherSide) {
  Clip clip = synthetic_clip(steady_walk(1.2, 1.0));
  clip.body.joints[LeftElbow].offset *= 1.1;  // no body is symmetric
  clip.poses[20].rotations[Chest] = about(Vec3(1, 2, 3).normalized(), 0.4);
  const Clip seen = mirrored(clip);
  const auto original = joint_paths(clip);
  const auto image = joint_paths(seen);
  for (size_t t = 0; t < original.size(); ++t) {
    for (int j = 0; j < body_joint_count; ++j) {
      const Vec3 expected = mirrored_place(original[t][mirrored(BodyJoint(j))]);
      EXPECT_NEAR((image[t][j] - expected).norm(), 0.0, 1e-12);
    }
  }
}

TEST(Mirror, TwiceIsTheClip) {
  const Clip clip = synthetic_clip(steady_walk(1.0, 0.3));
  const Clip twice = mirrored(mirrored(clip));
  for (size_t t = 0; t < clip.poses.size(); ++t) {
    EXPECT_EQ(twice.poses[t].root_position, clip.poses[t].root_position);
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_EQ(twice.poses[t].rotations[j].coeffs(), clip.poses[t].rotations[j].coeffs());
    }
  }
}

}  // namespace
}  // namespace mien::motion
