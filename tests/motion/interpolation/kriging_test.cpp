#include "motion/interpolation/kriging.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/random_places.h"

namespace mien::motion {
namespace {

using test::random_places;

// Two places and a constant mean: w solves [0 g 1; g 0 1; 1 1 0] by hand.
TEST(Kriging, OfTwoPlacesIsTheCaseWorkedByHand) {
  const Eigen::MatrixXd places = (Eigen::MatrixXd(2, 1) << 0.0, 1.0).finished();
  const Kriging kriging = fit_kriging(places, {.linear_drift = false});
  EXPECT_DOUBLE_EQ(kriging.variogram.range, 1.0);
  const auto gamma = [](double h) { return 1.0 - std::exp(-h * h); };
  const double near = gamma(0.25), far = gamma(0.75), across = gamma(1.0);
  const double first = 0.5 + 0.5 * (far - near) / across;
  const double multiplier = near - across * (1.0 - first);
  const KrigedWeights found = kriged_weights(kriging, Eigen::RowVectorXd::Constant(1, 0.25));
  EXPECT_NEAR(found.weights[0], first, 1e-12);
  EXPECT_NEAR(found.weights[1], 1.0 - first, 1e-12);
  EXPECT_NEAR(found.variance, first * near + (1.0 - first) * far + multiplier, 1e-12);
}

TEST(Kriging, ReproducesLinearFunctionsEverywhere) {
  std::mt19937_64 random(41);
  const Eigen::MatrixXd places = random_places(random, 12, 3);
  const Kriging kriging = fit_kriging(places);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::RowVectorXd wish = 4.0 * random_places(random, 1, 3).array() - 1.5;
    const Eigen::VectorXd weights = kriged_weights(kriging, wish).weights;
    EXPECT_LT((weights.transpose() * places - wish).norm(), 1e-8);
  }
}

// The variance is the least of all weights that reproduce linear functions: any other such weights
// have more (Σ 2wγ − wΓw of the intrinsic model).
TEST(Kriging, HasTheLeastVarianceOfAllUnbiasedWeights) {
  std::mt19937_64 random(42);
  const Eigen::MatrixXd places = random_places(random, 9, 2);
  const Kriging kriging = fit_kriging(places);
  const Eigen::RowVectorXd wish = random_places(random, 1, 2);
  const KrigedWeights best = kriged_weights(kriging, wish);
  const auto variance = [&](const Eigen::VectorXd& w) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 9; ++i) {
      sum += 2.0 * w[i] * kriging.variogram((places.row(i) - wish).norm());
      for (Eigen::Index k = 0; k < 9; ++k) {
        sum -= w[i] * w[k] * kriging.variogram((places.row(i) - places.row(k)).norm());
      }
    }
    return sum;
  };
  EXPECT_NEAR(variance(best.weights), best.variance, 1e-9);
  Eigen::MatrixXd drift(9, 3);
  drift << Eigen::VectorXd::Ones(9), places;
  const Eigen::MatrixXd null = Eigen::FullPivLU<Eigen::MatrixXd>(drift.transpose()).kernel();
  for (int trial = 0; trial < 30; ++trial) {
    const Eigen::VectorXd other =
        best.weights + 0.1 * null * (random_places(random, null.cols(), 1).array() - 0.5).matrix();
    EXPECT_GE(variance(other), best.variance - 1e-12);
  }
}

TEST(Kriging, FindsTheVariogramThatMadeTheDifferences) {
  std::mt19937_64 random(43);
  const Eigen::MatrixXd places = random_places(random, 30, 2);
  // The ladder of ranges holds the median distance times powers of the fourth root of two.
  const double median = fit_kriging(places).variogram.range;
  const Variogram truth{0.02, median * std::exp2(0.5)};
  Eigen::MatrixXd differences(30, 30);
  for (Eigen::Index i = 0; i < 30; ++i) {
    for (Eigen::Index k = 0; k < 30; ++k) {
      differences(i, k) = truth((places.row(i) - places.row(k)).norm());
    }
  }
  const Kriging kriging = fit_kriging(places, {.nugget = 0.01}, differences);
  EXPECT_TRUE(kriging.fitted);
  EXPECT_NEAR(kriging.variogram.range * std::exp2(kriging.halvings), truth.range, 1e-12);
  EXPECT_NEAR(kriging.variogram.sill, truth.sill, 1e-12);
}

TEST(Kriging, SmoothsWithANugget) {
  std::mt19937_64 random(44);
  const Eigen::MatrixXd places = random_places(random, 10, 2);
  const KrigedWeights exact = kriged_weights(fit_kriging(places), places.row(4));
  const KrigedWeights smooth = kriged_weights(fit_kriging(places, {.nugget = 0.2}), places.row(4));
  EXPECT_NEAR(exact.weights[4], 1.0, 1e-9);
  EXPECT_NEAR(exact.variance, 0.0, 1e-9);
  EXPECT_LT(smooth.weights[4], 0.99);
  EXPECT_GT(smooth.variance, 1e-3);
  EXPECT_NEAR(smooth.weights.sum(), 1.0, 1e-9);
}

TEST(Kriging, StaysSolvableWhenPlacesCrowd) {
  Eigen::MatrixXd places(25, 1);
  for (int i = 0; i < 25; ++i) places(i, 0) = i / 24.0;
  const Kriging kriging = fit_kriging(places);
  EXPECT_GT(kriging.halvings, 0);
  for (Eigen::Index k = 0; k < 25; ++k) {
    const Eigen::VectorXd weights = kriged_weights(kriging, places.row(k)).weights;
    EXPECT_LT((weights - Eigen::VectorXd::Unit(25, k)).cwiseAbs().maxCoeff(), 1e-6);
  }
}

}  // namespace
}  // namespace mien::motion
