#include <gtest/gtest.h>

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Jumps, OfTheWholeBodyAreErrors) {
  Clip clip = three_cycles(builtin_walks()[0]);
  for (int t = 40; t < clip.frame_count(); ++t) {
    clip.poses[t].root_position += Vec3(0.15, 0, 0);
  }
  const auto findings = lint(clip);
  const Finding* found = find_error(findings, "jump", "", 40, 40);
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_EQ(found->joint, "");
  EXPECT_NEAR(found->measured, 0.15, 0.03);
  EXPECT_EQ(found->unit, "m");
}

TEST(Jumps, OfOneFrameAreErrorsAtAnyRate) {
  for (const double rate : {30.0, 60.0, 120.0}) {
    Clip clip = resampled(three_cycles(builtin_walks()[0]), rate);
    const int frame = clip.frame_count() / 3;
    clip.poses[frame].rotations[LeftElbow] *= exp(Vec3(0, 40 * radians_per_degree, 0));
    EXPECT_TRUE(find_error(lint(clip), "jump", "LeftElbow", frame, frame + 1)) << rate;
  }
}

TEST(Jumps, AreNotWalksOfFewFramesASecond) {
  for (const Clip& walk : builtin_walks()) {
    for (const double rate : {24.0, 15.0, 12.0, 10.0}) {
      const Clip clip = resampled(three_cycles(walk), rate);
      EXPECT_FALSE(find(lint(clip), "jump", "")) << walk.name << " at " << rate << '\n'
                                                 << all_of(lint(clip));
      for (const auto& joint : clip.body.joints) {
        EXPECT_FALSE(find(lint(clip), "jump", joint.name)) << walk.name << " at " << rate;
      }
    }
  }
}

TEST(Jumps, AreNotFastWaves) {
  // A forearm that waves four times a second steps 40° between frames of a slow recording.
  Clip clip = three_cycles(builtin_walks()[0]);
  double farthest = 0.0;
  double before = 0.0;
  for (int t = 0; t < clip.frame_count(); ++t) {
    const double angle = -(1.0 + 0.85 * std::sin(2 * pi * 4.0 * t / clip.frames_per_second));
    clip.poses[t].rotations[LeftElbow] = exp(Vec3(0, angle, 0));
    if (t > 0) farthest = std::max(farthest, std::abs(angle - before));
    before = angle;
  }
  EXPECT_GT(farthest, 35 * radians_per_degree);
  EXPECT_FALSE(find(lint(clip), "jump", "LeftElbow")) << all_of(lint(clip));
}

TEST(Seam, OfTheWholeBodyIsFound) {
  Clip loop = builtin_walks()[0];
  for (int t = 0; t < loop.frame_count(); ++t) {
    loop.poses[t].root_position.y() += 0.06 * t / loop.frame_count();
  }
  const auto findings = lint(loop);
  const Finding* found = find_error(findings, "loop-seam");
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_EQ(found->joint, "");
  EXPECT_EQ(found->first, loop.frame_count() - 1);
  loop.loops = false;
  EXPECT_FALSE(find(lint(loop), "loop-seam"));
}

}  // namespace
}  // namespace mien::motion
