#include <gtest/gtest.h>

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Jerk, OfAHandThatTremblesIsFoundAgainstTheOriginal) {
  for (const Clip& loop : builtin_walks()) {
    const Clip before = resampled(three_cycles(loop), 60.0);
    Clip clip = before;
    for (int t = 60; t <= 90; ++t) {
      const double tremor = 0.12 * std::sin(2 * pi * 6.0 * t / 60.0) * bump(t, 60, 90);
      clip.poses[t].rotations[RightShoulder] *= exp(Vec3(0, tremor, tremor));
    }
    const auto findings = lint(clip, {}, &before);
    EXPECT_TRUE(find(findings, "jerk", "RightWrist", 60, 90)) << loop.name << all_of(findings);
    EXPECT_FALSE(find(findings, "jerk", "LeftWrist")) << loop.name << all_of(findings);
    EXPECT_FALSE(find(findings, "jerk", "Ankle")) << loop.name << all_of(findings);
    EXPECT_FALSE(find(lint(clip), "jerk")) << loop.name;
  }
}

}  // namespace
}  // namespace mien::motion
