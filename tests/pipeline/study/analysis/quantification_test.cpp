#include "pipeline/study/analysis/quantification.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

ScaleSet scales_of(double least, double most) {
  ScaleSet set;
  for (const char* id : {"a-b", "c-d", "e-f"}) {
    set.scales.push_back({.id = id, .low = "low", .high = "high", .least = least, .most = most});
  }
  return set;
}

/// Two examples, four raters; a-b is clear, c-d neutral, e-f disputed. On −2 … 2, stretched.
Impressions impressions(double unit, const ScaleSet& scales) {
  const std::vector<std::array<std::array<double, 4>, 2>> values = {
      {{{2, 2, 1, 1}, {-1, 0, 0, -1}}},
      {{{0, 1, 0, 1}, {0, 0, 0, 0}}},
      {{{2, 2, 2, -1}, {-2, 2, -2, 2}}}};
  Answers answers;
  for (size_t j = 0; j < 3; ++j) {
    for (size_t i = 0; i < 2; ++i) {
      for (size_t r = 0; r < 4; ++r) {
        answers.answers.push_back({"p" + std::to_string(r), i == 0 ? "x" : "y", scales.scales[j].id,
                                   unit * values[j][i][r]});
      }
    }
  }
  return impressions_of(answers, scales, {{"x", ""}, {"y", ""}});
}

TEST(Quantification, FollowsEquations1To3) {
  const ScaleSet scales = scales_of(-2, 2);
  const std::vector<Quantity> q = quantify(impressions(1.0, scales), scales);
  ASSERT_EQ(q.size(), 3u);
  EXPECT_NEAR(q[0].largest_mean, 1.5, 1e-12);
  EXPECT_EQ(q[0].extreme_example, 0);
  EXPECT_NEAR(q[0].mean_deviation, 0.5, 1e-12);
  EXPECT_TRUE(q[0].retained());
  EXPECT_NEAR(q[1].largest_mean, 0.5, 1e-12);
  EXPECT_NEAR(q[1].mean_deviation, 0.25, 1e-12);
  EXPECT_TRUE(q[1].neutral && !q[1].disputed);
  EXPECT_NEAR(q[2].largest_mean, 1.25, 1e-12);
  EXPECT_NEAR(q[2].mean_deviation, 0.5 * (std::sqrt(27.0) / 4.0 + 2.0), 1e-12);
  EXPECT_TRUE(!q[2].neutral && q[2].disputed);
}

TEST(Quantification, KeepsWhatIsExactlyAtAThreshold) {
  const ScaleSet scales = scales_of(-2, 2);
  const Impressions a = impressions(1.0, scales);
  EXPECT_TRUE(quantify(a, scales, {1.5, 0.5})[0].retained());
  EXPECT_TRUE(quantify(a, scales, {1.51, 0.5})[0].neutral);
  EXPECT_TRUE(quantify(a, scales, {1.5, 0.49})[0].disputed);
}

TEST(Quantification, OfAnotherRangeIsTheSameInProportion) {
  const ScaleSet narrow = scales_of(-2, 2);
  const ScaleSet wide = scales_of(-3, 3);
  const std::vector<Quantity> a = quantify(impressions(1.0, narrow), narrow);
  const std::vector<Quantity> b = quantify(impressions(1.5, wide), wide);
  for (size_t j = 0; j < a.size(); ++j) {
    EXPECT_NEAR(b[j].largest_mean, 1.5 * a[j].largest_mean, 1e-12);
    EXPECT_NEAR(b[j].mean_deviation, 1.5 * a[j].mean_deviation, 1e-12);
    EXPECT_NEAR(b[j].thresholds.largest_mean, 1.5, 1e-12);
    EXPECT_NEAR(b[j].thresholds.mean_deviation, 1.275, 1e-12);
    EXPECT_EQ(b[j].neutral, a[j].neutral);
    EXPECT_EQ(b[j].disputed, a[j].disputed);
  }
}

TEST(Quantification, OfASampleDividesByOneLess) {
  const ScaleSet scales = scales_of(-2, 2);
  const Impressions a = impressions(1.0, scales);
  EXPECT_NEAR(quantify(a, scales, {}, Deviation::sample)[0].mean_deviation,
              0.5 * std::sqrt(4.0 / 3.0), 1e-12);
}

TEST(Quantification, OfASampleLeavesOutExamplesWithOneAnswer) {
  const ScaleSet scales = scales_of(-2, 2);
  Answers answers;
  for (const double value : {2.0, -1.0, 2.0, -1.0})
    answers.answers.push_back({"p", "x", scales.scales[0].id, value});
  answers.answers.push_back({"p", "y", scales.scales[0].id, 1.0});
  for (std::size_t i = 0; i < 4; ++i) answers.answers[i].participant = "p" + std::to_string(i);
  for (std::size_t j = 1; j < scales.scales.size(); ++j)
    for (const char* example : {"x", "y"})
      answers.answers.push_back({"p", example, scales.scales[j].id, 1.0});
  const Impressions found = impressions_of(answers, scales, {{"x", ""}, {"y", ""}});
  const std::vector<Quantity> quantities = quantify(found, scales, {}, Deviation::sample);
  EXPECT_NEAR(quantities[0].mean_deviation, std::sqrt(3.0), 1e-12);
  EXPECT_TRUE(quantities[0].disputed);
  EXPECT_TRUE(std::isnan(quantities[1].mean_deviation)) << "nobody agrees or disagrees";
}

TEST(Quantification, MeansAloneCannotBeDisputed) {
  const ScaleSet scales = scales_of(-2, 2);
  Answers means;
  for (const Scale& scale : scales.scales) {
    means.answers.push_back({"", "x", scale.id, 1.5});
    means.answers.push_back({"", "y", scale.id, -0.5});
  }
  for (const Quantity& q :
       quantify(impressions_of(means, scales, {{"x", ""}, {"y", ""}}), scales, {1.0, 0.0})) {
    EXPECT_TRUE(std::isnan(q.mean_deviation));
    EXPECT_TRUE(q.retained());
  }
}

TEST(Quantification, TheCurveFallsWithTheMeanAndRisesWithTheDeviation) {
  const ScaleSet scales = scales_of(-3, 3);
  const std::vector<Quantity> q = quantify(impressions(1.5, scales), scales);
  const std::vector<ThresholdPoint> curve = threshold_curve(q, {}, scales);
  ASSERT_EQ(curve.size(), 82u);
  for (size_t k = 1; k < 41; ++k) {
    EXPECT_LE(curve[k].by_condition, curve[k - 1].by_condition);
    EXPECT_GE(curve[41 + k].by_condition, curve[40 + k].by_condition * (k > 1));
    EXPECT_LE(curve[k].by_both, curve[k].by_condition);
  }
  EXPECT_EQ(curve[0].by_condition, 3);
  EXPECT_EQ(curve[0].by_both, 2);   // without a condition on the mean the neutral one stays
  EXPECT_EQ(curve[20].by_both, 1);  // the thresholds of the paper
  EXPECT_EQ(curve[58].by_both, 1);
  EXPECT_EQ(curve[81].by_condition, 3);
}

TEST(Quantification, LoosenedThresholdsKeepAtLeastHalf) {
  const ScaleSet scales = scales_of(-2, 2);
  const Impressions a = impressions(1.0, scales);
  for (const Thresholds& strict :
       {Thresholds{1.9, 0.1}, Thresholds{1.9, 3.0}, Thresholds{0.2, 0.1}}) {
    const std::vector<Quantity> q = quantify(a, scales, strict);
    const Thresholds loose = loosened_thresholds(q, strict, scales);
    int retained = 0;
    for (const Quantity& again : quantify(a, scales, loose)) retained += again.retained();
    EXPECT_GE(retained, 2) << strict.largest_mean << ' ' << strict.mean_deviation;
    EXPECT_LE(loose.largest_mean, strict.largest_mean);
    EXPECT_GE(loose.mean_deviation, strict.mean_deviation);
  }
  // Two of three are retained already.
  const Thresholds mild = {1.0, 1.7};
  const Thresholds same = loosened_thresholds(quantify(a, scales, mild), mild, scales);
  EXPECT_EQ(same.largest_mean, 1.0);
  EXPECT_EQ(same.mean_deviation, 1.7);
}

}  // namespace
}  // namespace mien::pipeline
