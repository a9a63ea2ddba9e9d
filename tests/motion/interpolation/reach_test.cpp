#include "motion/interpolation/reach.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/math/convex_weights.h"

namespace mien::motion {
namespace {

/// Examples on parameters of 0 … 1, one row an example.
Eigen::MatrixXd random_places(std::mt19937& random, Eigen::Index count, Eigen::Index parameters) {
  std::uniform_real_distribution<double> uniform;
  return Eigen::MatrixXd::NullaryExpr(count, parameters, [&] { return uniform(random); });
}

Eigen::VectorXd random_blend(std::mt19937& random, Eigen::Index count) {
  const Eigen::VectorXd shares = random_places(random, count, 1).array().pow(4);
  return shares / shares.sum();
}

TEST(Reach, MeetsWhatIsAskedWhereTheExamplesAllowIt) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd places = random_places(random, 5 + trial % 26, 1 + trial % 4);
    const Eigen::RowVectorXd asked =
        (places.transpose() * random_blend(random, places.rows())).transpose();
    const Eigen::VectorXd found = weights(fit_reach(places, 0), asked);
    ASSERT_GE(found.minCoeff(), -1e-12);
    ASSERT_NEAR(found.sum(), 1.0, 1e-12);
    ASSERT_NEAR((places.transpose() * found - asked.transpose()).norm(), 0.0, 1e-9) << trial;
  }
}

// The basis alone misses: its weights below 0 are cut off.
TEST(Reach, MeetsWhatTheBasisMisses) {
  std::mt19937 random(2);
  double worst = 0.0;
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd places = random_places(random, 10, 2);
    const Eigen::RowVectorXd asked = (places.transpose() * random_blend(random, 10)).transpose();
    const Eigen::VectorXd basis = weights(fit_cardinal_basis(places), asked);
    worst = std::max(worst, (places.transpose() * basis - asked.transpose()).norm());
  }
  EXPECT_GT(worst, 0.02);
}

TEST(Reach, IsTheNearestToTheBasisThatMeetsIt) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::MatrixXd places = random_places(random, 8, 2);
    const Eigen::RowVectorXd asked = (places.transpose() * random_blend(random, 8)).transpose();
    const Eigen::VectorXd basis = weights(fit_cardinal_basis(places), asked);
    const Eigen::VectorXd found = weights(fit_reach(places, 0), asked);
    // Any other weights that meet it, as far from the basis at least.
    for (int other = 0; other < 50; ++other) {
      const Eigen::VectorXd any = least_squares_at_mean(
          places.transpose(), weights_nearest_to(places.transpose(), asked.transpose()),
          Eigen::MatrixXd::Identity(8, 8), random_blend(random, 8));
      ASSERT_GE((any - basis).norm(), (found - basis).norm() - 1e-9);
    }
  }
}

TEST(Reach, GivesAnExampleAloneAtItsOwnParameters) {
  std::mt19937 random(4);
  const Eigen::MatrixXd places = random_places(random, 9, 3);
  const Reach reach = fit_reach(places, 0);
  for (Eigen::Index i = 0; i < 9; ++i)
    EXPECT_NEAR(weights(reach, places.row(i))[i], 1.0, 1e-8) << i;
}

TEST(Reach, MissesAsLittleAsPossibleWhatTheExamplesDoNotAllow) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::MatrixXd places = random_places(random, 9, 2);
    const Eigen::RowVector2d asked(1.5, trial * 0.02 - 0.5);
    const Eigen::VectorXd missed =
        asked.transpose() - places.transpose() * weights(fit_reach(places, 0), asked);
    ASSERT_LE(((places.rowwise() - (asked - missed.transpose())) * missed).maxCoeff(), 1e-9);
  }
}

/// The largest change of weights from one of `steps` points of a way to the next. The way leads
/// through the hull of the examples and out of it on both sides.
double largest_change(const Reach& reach, int steps) {
  double largest = 0.0;
  Eigen::VectorXd last;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Eigen::VectorXd now =
        weights(reach, Eigen::RowVector2d(1.6 * t - 0.3, 0.2 + 0.5 * t * t));
    if (i > 0) largest = std::max(largest, (now - last).lpNorm<Eigen::Infinity>());
    last = now;
  }
  return largest;
}

TEST(Reach, FollowsTheParametersContinuously) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 10; ++trial) {
    const Reach reach = fit_reach(random_places(random, 12, 2), 0);
    EXPECT_LT(largest_change(reach, 4000), 0.35 * largest_change(reach, 1000) + 1e-6) << trial;
  }
}

TEST(Reach, HoldsTheOtherParametersWhereTheExamplesAllowIt) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::MatrixXd places = random_places(random, 20, 4);
    const Eigen::RowVectorXd wish = (places.transpose() * random_blend(random, 20)).transpose();
    const Eigen::VectorXd found = weights(fit_reach(places, 3), wish);
    ASSERT_NEAR(places.col(0).dot(found), wish[0], 1e-9);
    ASSERT_NEAR((places.transpose() * found - wish.transpose()).norm(), 0.0, 1e-5) << trial;
  }
}

// Extraversion alone is asked for; what is held cannot be, and must not cost any of it.
TEST(Reach, MeetsWhatIsAskedBeforeWhatIsHeld) {
  Eigen::MatrixXd places(3, 2);
  places << 0.1, 0.1, 0.5, 0.6, 0.9, 0.8;
  const Eigen::VectorXd found = weights(fit_reach(places, 1), Eigen::RowVector2d(0.8, 0.1));
  EXPECT_NEAR(places.col(0).dot(found), 0.8, 1e-9);
  // Of 0.8 the examples have between the straight line to the third and the way over the second.
  EXPECT_NEAR(places.col(1).dot(found), 0.1 + 0.7 * 0.7 / 0.8, 1e-4);
}

TEST(FeasibleRange, IsWhatBlendsOfThoseOtherParametersHave) {
  // A triangle: at 0.5 of the second parameter its sides are at 0.25 and 0.75 of the first.
  Eigen::MatrixXd places(3, 2);
  places << 0.0, 0.0, 1.0, 0.0, 0.5, 1.0;
  const ParameterRange range = feasible_range(places, Eigen::RowVector2d(0.0, 0.5), 0);
  EXPECT_NEAR(range.least, 0.25, 1e-6);
  EXPECT_NEAR(range.most, 0.75, 1e-6);
}

TEST(FeasibleRange, OfOneParameterIsThatOfTheExamples) {
  const Eigen::MatrixXd places = Eigen::Vector4d(0.3, 0.94, 0.06, 0.5);
  const ParameterRange range = feasible_range(places, Eigen::RowVectorXd::Constant(1, 0.5), 0);
  EXPECT_NEAR(range.least, 0.06, 1e-6);
  EXPECT_NEAR(range.most, 0.94, 1e-6);
}

TEST(FeasibleRange, IsReachedAtItsEndsAndNotBeyond) {
  std::mt19937 random(8);
  for (int trial = 0; trial < 60; ++trial) {
    const Eigen::MatrixXd places = random_places(random, 12, 3);
    Eigen::RowVectorXd wish = (places.transpose() * random_blend(random, 12)).transpose();
    const ParameterRange range = feasible_range(places, wish, 1);
    ASSERT_LE(range.least, wish[1] + 1e-6);
    ASSERT_GE(range.most, wish[1] - 1e-6);
    const Reach reach = fit_reach(places, 0);
    for (const auto& [value, is_met] : {std::pair{range.least + 1e-5, true},
                                        {range.most - 1e-5, true},
                                        {range.least - 1e-3, false},
                                        {range.most + 1e-3, false}}) {
      wish[1] = value;
      const double miss = (places.transpose() * weights(reach, wish) - wish.transpose()).norm();
      ASSERT_EQ(miss < 1e-8, is_met) << trial << " " << value << " " << miss;
    }
  }
}

TEST(EffectiveExamples, CountsEqualWeights) {
  EXPECT_DOUBLE_EQ(effective_examples(Eigen::VectorXd::Constant(4, 0.25)), 4.0);
  EXPECT_DOUBLE_EQ(effective_examples(Eigen::Vector3d(0, 1, 0)), 1.0);
}

}  // namespace
}  // namespace mien::motion
