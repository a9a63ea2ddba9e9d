#include <gtest/gtest.h>

#include "motion/formats/bvh/bvh.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/random_recording.h"

namespace mien::motion {
namespace {

void expect_identical(const Recording& a, const Recording& b) {
  EXPECT_EQ(a.frames_per_second, b.frames_per_second);
  EXPECT_EQ(a.format, b.format);
  ASSERT_EQ(a.skeleton.size(), b.skeleton.size());
  for (std::size_t j = 0; j < a.skeleton.joints.size(); ++j) {
    const Joint& p = a.skeleton.joints[j];
    const Joint& q = b.skeleton.joints[j];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.parent, q.parent);
    EXPECT_EQ(p.offset, q.offset);
    EXPECT_EQ(p.tip, q.tip);
  }
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    ASSERT_EQ(a.poses[f].root_position, b.poses[f].root_position) << "frame " << f;
    ASSERT_EQ(a.poses[f].rotations.size(), b.poses[f].rotations.size());
    for (std::size_t j = 0; j < a.poses[f].rotations.size(); ++j) {
      ASSERT_EQ(a.poses[f].rotations[j].coeffs(), b.poses[f].rotations[j].coeffs())
          << "frame " << f << ", joint " << j;
    }
  }
}

TEST(BvhAsRead, IsToTheLastBitWhatItsTextIsReadAs) {
  std::mt19937_64 random(71);
  for (int trial = 0; trial < 100; ++trial) {
    Recording recording = test::random_recording(random, {.joints = 9, .frames = 12});
    if (trial % 4 == 0) recording.frames_per_second = 30000.0 / 1001.0;
    expect_identical(as_read_from_bvh(recording), parse_bvh(to_bvh(recording), "random.bvh"));
  }
}

TEST(BvhAsRead, RoundsHalvesAsTheWriterDoes) {
  Recording recording;
  recording.name = "halves";
  recording.skeleton.joints.push_back({.name = "root", .tip = Vec3(0.0, 1.0, 0.0)});
  // Odd multiples of 1/256 have eight decimals, the last a 5: they lie half way.
  for (int k = -601; k < 600; k += 2) {
    Pose pose;
    pose.root_position = Vec3(k / 256.0, std::nextafter(k / 256.0, 10.0), -1e-9 * k);
    pose.rotations.push_back(Quat::Identity());
    recording.poses.push_back(pose);
  }
  expect_identical(as_read_from_bvh(recording), parse_bvh(to_bvh(recording), "halves.bvh"));
}

TEST(BvhAsRead, HoldsForWalksThatAreRepeated) {
  for (const Example& example : builtin_examples("walks-10").examples) {
    Clip clip = repeated(example.clip, 3);
    clip.name = "walk";
    expect_identical(as_read_from_bvh(to_recording(clip)),
                     parse_bvh(to_bvh(to_recording(clip)), "walk.bvh"));
  }
}

}  // namespace
}  // namespace mien::motion
