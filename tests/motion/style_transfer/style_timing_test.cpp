#include "motion/style_transfer/style_timing.h"

#include <random>

#include <gtest/gtest.h>

#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(StyleTiming, OfNoAmountIsThatOfTheMotion) {
  const Example happy = builtin_walk("happy");
  const auto keytimes = styled_keytimes(happy, builtin_walk("normal"), builtin_walk("sad"), 0.0,
                                        happy.keytimes.back());
  for (size_t k = 0; k < keytimes.size(); ++k) EXPECT_NEAR(keytimes[k], happy.keytimes[k], 1e-12);
}

TEST(StyleTiming, OfTheNeutralMotionBecomesThatOfTheStyledOne) {
  const Example sad = builtin_walk("sad");
  const Example normal = builtin_walk("normal");
  const auto keytimes = styled_keytimes(normal, normal, sad, 1.0, sad.keytimes.back());
  for (size_t k = 0; k < keytimes.size(); ++k) EXPECT_NEAR(keytimes[k], sad.keytimes[k], 1e-12);
}

TEST(StyleTiming, KeepsItsOrderAtAnyAmount) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> interval(0.02, 1.0);
  const auto any = [&] {
    Example example{"", builtin_walk("normal").clip, {0.0}};
    for (int k = 0; k < 6; ++k)
      example.keytimes.push_back(example.keytimes.back() + interval(random));
    return example;
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Example motion = any();
    const auto keytimes = styled_keytimes(motion, any(), any(), 0.1 * (trial % 40), 1.7);
    EXPECT_EQ(keytimes.front(), 0.0);
    EXPECT_EQ(keytimes.back(), 1.7);
    for (size_t k = 1; k < keytimes.size(); ++k) EXPECT_GT(keytimes[k], keytimes[k - 1]) << trial;
    const auto frames = corresponding_frames(motion, keytimes, 50);
    for (size_t f = 1; f < frames.size(); ++f) EXPECT_GT(frames[f], frames[f - 1]) << trial;
  }
}

}  // namespace
}  // namespace mien::motion
