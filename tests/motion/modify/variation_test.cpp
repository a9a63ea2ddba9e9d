#include "motion/modify/variation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/procedural/walker.h"

#include "path_measures.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(WanderingCurve, DependsOnSeedAndNameAlone) {
  const auto curve = smooth_random_curve(7, "left hand", 300, 100.0, false);
  EXPECT_EQ(curve, smooth_random_curve(7, "left hand", 300, 100.0, false));
  EXPECT_NE(curve, smooth_random_curve(8, "left hand", 300, 100.0, false));
  EXPECT_NE(curve, smooth_random_curve(7, "right hand", 300, 100.0, false));
}

TEST(WanderingCurve, IsSmoothAndFillsItsRange) {
  double least = 1.0;
  double most = -1.0;
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto curve = smooth_random_curve(seed, "curve", 1000, 100.0, false);
    for (size_t f = 1; f < curve.size(); ++f) {
      EXPECT_LT(std::abs(curve[f] - curve[f - 1]), 0.06);
      least = std::min(least, curve[f]);
      most = std::max(most, curve[f]);
      sum += curve[f] / 50.0 / 1000.0;
    }
  }
  EXPECT_LT(least, -0.9);
  EXPECT_GT(most, 0.9);
  EXPECT_GT(least, -1.4);
  EXPECT_LT(most, 1.4);
  // 750 numbers, evenly from −1 to 1: the mean's standard deviation is 0.021.
  EXPECT_NEAR(sum, 0.0, 0.07);
}

TEST(WanderingCurve, GoesOnOverTheSeamOfALoop) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto curve = smooth_random_curve(seed, "curve", 110, 100.0, true);
    EXPECT_LT(std::abs(curve.front() - curve.back()), 0.12);
  }
}

TEST(Variation, MovesTheLimbsItIsAskedFor) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  Limbs limbs;
  limbs.right_hand = false;
  limbs.head = false;
  const Clip varied = with_variation(clip, 1.0, limbs, 3);
  double moved = 0.0;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    for (const int joint : {Neck, Head, RightShoulder, RightElbow, LeftHip, Spine}) {
      EXPECT_EQ(varied.poses[f].rotations[size_t(joint)].coeffs(),
                clip.poses[f].rotations[size_t(joint)].coeffs());
    }
    moved = std::max(moved, varied.poses[f].rotations[LeftShoulder].angularDistance(
                                clip.poses[f].rotations[LeftShoulder]));
  }
  EXPECT_GT(moved, 0.02);
}

TEST(Variation, IsNoNoise) {
  for (const bool loops : {true, false}) {
    const Clip loop = walk({}, 100.0, standard_body()).clip;
    const Clip clip = loops ? loop : repeated(loop, 4);
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      EXPECT_LT(largest_second_difference(with_variation(clip, 1.0, {}, seed)),
                1.5 * largest_second_difference(clip));
    }
  }
}

}  // namespace
}  // namespace mien::motion
