#include "pipeline/study/analysis/rating_estimates.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct World {
  RatedMotions motions;
  MeanRatings ratings;
  VectorXd truth;
};

/// Styles of two takes each, whose true ratings are a smooth function of two features of six (share
/// `lawful` of their variance) and a deviation of the style; each is rated by `raters` people.
World world(unsigned seed, int styles, double lawful, int raters, double answer_sd) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const int count = 2 * styles;
  World w;
  w.motions.features.resize(count, 6);
  w.motions.families = {{0, 1}, {2, 3}, {4, 5}};
  w.truth.resize(count);
  w.ratings = {"made", VectorXd(count), VectorXd(count), Eigen::VectorXi(count)};
  for (int style = 0; style < styles; ++style) {
    Eigen::RowVectorXd place(6);
    for (double& x : place) x = normal(random);
    const double own = normal(random);
    for (int i = 2 * style; i < 2 * style + 2; ++i) {
      for (int k = 0; k < 6; ++k) w.motions.features(i, k) = place[k] + 0.2 * normal(random);
      const double law = 0.7 * w.motions.features(i, 0) + 0.7 * w.motions.features(i, 4);
      w.truth[i] = 0.5 + 0.1 * (std::sqrt(lawful) * law + std::sqrt(1.0 - lawful) * own);
      w.motions.style.push_back(style);
      VectorXd answers(raters);
      for (double& answer : answers) answer = w.truth[i] + answer_sd * normal(random);
      w.ratings.mean[i] = answers.mean();
      w.ratings.deviation[i] = std::sqrt((answers.array() - answers.mean()).square().mean());
      w.ratings.answers[i] = raters;
    }
  }
  return w;
}

TEST(RatingEstimates, ReliabilityOfMeansIsTheShareOfTrueVariance) {
  // Shrout and Fleiss 1979, table 2 (six targets, four judges): ICC(1,k) = 0.44.
  const std::vector<std::vector<double>> judged = {{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                                                   {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
  MeanRatings published{"published", VectorXd(6), VectorXd(6), Eigen::VectorXi::Constant(6, 4)};
  for (Index i = 0; i < 6; ++i) {
    const VectorXd row = Eigen::Map<const VectorXd>(judged[static_cast<std::size_t>(i)].data(), 4);
    published.mean[i] = row.mean();
    published.deviation[i] = std::sqrt((row.array() - row.mean()).square().mean());
  }
  EXPECT_NEAR(reliability_of(published).icc_one_k, 0.44, 0.005);
  const World w = world(1, 300, 0.5, 8, 0.2);
  const double of_truth = (w.truth.array() - w.truth.mean()).square().mean();
  EXPECT_NEAR(reliability_of(w.ratings).icc_one_k, of_truth / (of_truth + 0.04 / 8), 0.03);
}

TEST(RatingEstimates, CeilingIsTheR2OfTheTruthOnAverage) {
  double ceiling = 0.0;
  double of_truth = 0.0;
  constexpr int worlds = 40;
  for (unsigned seed = 40; seed < 40 + worlds; ++seed) {
    const World w = world(seed, 12, 0.5, 6, 0.2);
    const EstimateCheck check = check_without_styles(w.motions, w.ratings);
    ceiling += check.ceiling / worlds;
    of_truth += (1.0 - (w.ratings.mean - w.truth).squaredNorm() /
                           (w.ratings.mean - check.mean_of_others).squaredNorm()) /
                worlds;
  }
  EXPECT_NEAR(ceiling, of_truth, 0.03);
}

TEST(RatingEstimates, FindsALawAndNothingInNoise) {
  const World lawful = world(3, 15, 1.0, 15, 0.1);
  const ScaleEstimator found = fit_estimator(lawful.motions, lawful.ratings, {.permutations = 19});
  EXPECT_GT(found.check.r_squared, 0.6);
  EXPECT_DOUBLE_EQ(found.check.p, 0.05);
  EXPECT_TRUE(found.is_usable());
  EXPECT_TRUE(found.reaches_aim());
  double sum = 0.0;
  for (unsigned seed = 10; seed < 30; ++seed) {
    const World lawless = world(seed, 15, 0.0, 15, 0.1);
    sum += check_without_styles(lawless.motions, lawless.ratings).r_squared;
  }
  EXPECT_LE(sum / 20.0, 0.0);
}

TEST(RatingEstimates, StylesThatAreLeftOutDoNotLeak) {
  World w = world(4, 10, 0.5, 10, 0.1);
  const EstimateCheck before = check_without_styles(w.motions, w.ratings);
  w.ratings.mean[6] += 0.4;  // of style 3
  w.ratings.mean[7] += 0.4;
  const EstimateCheck after = check_without_styles(w.motions, w.ratings);
  for (const Index i : {6, 7}) {
    EXPECT_DOUBLE_EQ(after.estimated[i], before.estimated[i]);
    EXPECT_DOUBLE_EQ(after.variance[i], before.variance[i]);
    EXPECT_DOUBLE_EQ(after.mean_of_others[i], before.mean_of_others[i]);
  }
  EXPECT_NE(after.estimated[0], before.estimated[0]);
  const double near_0 = w.motions.features(0, 0);
  w.motions.features.row(7).setConstant(1e3);  // neither do their features
  const EstimateCheck moved = check_without_styles(w.motions, w.ratings);
  EXPECT_DOUBLE_EQ(moved.estimated[6], after.estimated[6]);
  EXPECT_DOUBLE_EQ(w.motions.features(0, 0), near_0);
}

TEST(RatingEstimates, IntervalsOfNewMotionsCoverTheTruth) {
  int covered = 0;
  int all = 0;
  for (unsigned seed = 100; seed < 160; ++seed) {
    const World w = world(seed, 17, 0.5, 12, 0.2);
    World known = w;  // without the last two styles
    known.motions.features.conservativeResize(30, 6);
    known.motions.style.resize(30);
    known.ratings.mean.conservativeResize(30);
    known.ratings.deviation.conservativeResize(30);
    known.ratings.answers.conservativeResize(30);
    const ScaleEstimator estimator =
        fit_estimator(known.motions, known.ratings, {.permutations = 0});
    for (const Index i : {30, 32}) {
      const RatingEstimate e = estimate(estimator, w.motions.features.row(i));
      if (w.truth[i] >= e.low_90 && w.truth[i] <= e.high_90) ++covered;
      ++all;
    }
  }
  EXPECT_NEAR(covered / static_cast<double>(all), 0.9, 0.082);  // 3 standard errors
}

TEST(RatingEstimates, OfGivenMeansHaveNoCeiling) {
  World w = world(5, 8, 0.5, 10, 0.1);
  w.ratings.answers.setOnes();
  w.ratings.deviation.setConstant(std::numeric_limits<double>::quiet_NaN());
  const ScaleEstimator estimator = fit_estimator(w.motions, w.ratings, {.permutations = 0});
  EXPECT_TRUE(std::isnan(estimator.check.ceiling));
  EXPECT_FALSE(estimator.reaches_aim());
  EXPECT_TRUE(std::isfinite(estimator.check.r_squared));
}

TEST(RatingEstimates, AConstantFeatureChangesNothing) {
  World w = world(6, 8, 0.5, 10, 0.1);
  w.motions.features.col(2).setConstant(3.0);
  const ScaleEstimator estimator = fit_estimator(w.motions, w.ratings, {.permutations = 0});
  Eigen::RowVectorXd motion = w.motions.features.row(0);
  const double before = estimate(estimator, motion).value;
  motion[2] = 99.0;
  EXPECT_DOUBLE_EQ(estimate(estimator, motion).value, before);
}

TEST(RatingEstimates, NeedFourStyles) {
  World w = world(7, 3, 0.5, 10, 0.1);
  EXPECT_THROW(fit_estimator(w.motions, w.ratings), Error);
}

}  // namespace
}  // namespace mien::pipeline
