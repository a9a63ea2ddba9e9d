#include "motion/measures/features/feature_scale.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<FeatureValues> random_examples(unsigned seed, size_t count) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(3.0, 20.0);
  std::vector<FeatureValues> examples(count);
  for (FeatureValues& example : examples) {
    for (double& value : example) value = normal(random);
  }
  return examples;
}

TEST(FeatureScale, PutsTheExamplesBetweenZeroAndOneAndTouchesBoth) {
  const auto examples = random_examples(1, 9);
  const FeatureScale scale = fit_feature_scale(examples);
  FeatureValues least, most;
  least.fill(2.0);
  most.fill(-1.0);
  for (const FeatureValues& example : examples) {
    const FeatureValues s = scaled(scale, example);
    for (size_t i = 0; i < s.size(); ++i) {
      least[i] = std::min(least[i], s[i]);
      most[i] = std::max(most[i], s[i]);
    }
  }
  for (size_t i = 0; i < least.size(); ++i) {
    EXPECT_DOUBLE_EQ(least[i], 0.0);
    EXPECT_DOUBLE_EQ(most[i], 1.0);
  }
}

TEST(FeatureScale, ZScoresHaveMeanZeroAndDeviationOne) {
  const auto examples = random_examples(2, 12);
  const FeatureScale scale = fit_feature_scale(examples, FeatureScaling::z_score);
  for (size_t i = 0; i < motion_feature_count; ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const FeatureValues& example : examples) {
      const double z = scaled(scale, example)[i];
      sum += z;
      squares += z * z;
    }
    EXPECT_NEAR(sum, 0.0, 1e-10);
    EXPECT_NEAR(squares / 12.0, 1.0, 1e-10);
  }
}

TEST(FeatureScale, WhatDoesNotDifferIsInTheMiddle) {
  auto examples = random_examples(3, 4);
  for (size_t k = 0; k < examples.size(); ++k) {
    examples[k][0] = 7.0 + 1e-9 * static_cast<double>(k);  // the noise of arithmetic
    examples[k][1] = 7.0 + 1e-3 * static_cast<double>(k);
  }
  EXPECT_DOUBLE_EQ(scaled(fit_feature_scale(examples), examples[3])[0], 0.5);
  EXPECT_DOUBLE_EQ(scaled(fit_feature_scale(examples), examples[3])[1], 1.0);
  EXPECT_DOUBLE_EQ(scaled(fit_feature_scale(examples, FeatureScaling::z_score), examples[3])[0],
                   0.0);
}

TEST(FeatureScale, WhatOneExampleLacksHasNoScale) {
  auto examples = random_examples(4, 4);
  examples[2][5] = nan;
  const FeatureValues s = scaled(fit_feature_scale(examples), examples[0]);
  EXPECT_TRUE(std::isnan(s[5]));
  EXPECT_FALSE(std::isnan(s[6]));
}

TEST(FeatureScale, AGroupIsTheMeanOfItsFeatures) {
  FeatureValues s;
  s.fill(0.25);
  s[static_cast<size_t>(find_motion_feature("sigma-head-lr"))] = 0.85;
  EXPECT_NEAR(*group_mean(s, FeatureGroup::lateral_swing), (5 * 0.25 + 0.85) / 6, 1e-12);
  EXPECT_NEAR(*group_mean(s, FeatureGroup::step_length), 0.25, 1e-12);
  s[static_cast<size_t>(find_motion_feature("sigma-head-lr"))] = nan;
  EXPECT_NEAR(*group_mean(s, FeatureGroup::lateral_swing), 0.25, 1e-12);
  s.fill(nan);
  EXPECT_FALSE(group_mean(s, FeatureGroup::lateral_swing).has_value());
}

}  // namespace
}  // namespace mien::motion
