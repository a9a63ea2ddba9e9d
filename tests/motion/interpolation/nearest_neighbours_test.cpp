#include "motion/interpolation/nearest_neighbours.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

const Eigen::MatrixXd corners = (Eigen::MatrixXd(4, 2) << 0, 0, 1, 0, 0, 1, 1, 1).finished();

TEST(NearestNeighbours, WeighByInverseDistanceLessThatOfTheFarthest) {
  const NearestNeighbours samples = fit_nearest_neighbours(corners, {.neighbours = 3, .trials = 0});
  const Eigen::RowVector2d at(0.25, 0.0);
  const double d0 = 0.25, d1 = 0.75, d2 = std::hypot(0.25, 1.0);
  const double w0 = 1 / d0 - 1 / d2, w1 = 1 / d1 - 1 / d2;
  const Eigen::VectorXd found = weights(samples, at);
  EXPECT_NEAR(found[0], w0 / (w0 + w1), 1e-14);
  EXPECT_NEAR(found[1], w1 / (w0 + w1), 1e-14);
  EXPECT_EQ(found[2], 0.0);
  EXPECT_EQ(found[3], 0.0);
}

TEST(NearestNeighbours, ShareEquallyWhenNoneIsNearer) {
  const NearestNeighbours samples = fit_nearest_neighbours(corners, {.neighbours = 4, .trials = 0});
  EXPECT_LT(
      (weights(samples, Eigen::RowVector2d(0.5, 0.5)) - Eigen::Vector4d::Constant(0.25)).norm(),
      1e-14);
}

TEST(NearestNeighbours, DensifiedMeetTheWishBetter) {
  const auto miss = [&](int trials) {
    const NearestNeighbours samples = fit_nearest_neighbours(corners, {.trials = trials});
    double sum = 0.0;
    for (int i = 0; i < 400; ++i) {
      const Eigen::RowVector2d wish((i % 20 + 0.5) / 20.0, (i / 20 + 0.5) / 20.0);
      sum += (weights(samples, wish).transpose() * corners - wish).norm();
    }
    return sum / 400;
  };
  EXPECT_LT(miss(300), 0.25 * miss(0));
}

TEST(NearestNeighbours, KeepRandomBlendsThatAreFarFromAllOthers) {
  const NearestNeighbours samples =
      fit_nearest_neighbours(corners, {.trials = 300, .least_distance = 0.2, .seed = 3});
  const Eigen::Index count = samples.parameters.rows();
  EXPECT_GT(count, 8);
  for (Eigen::Index i = 0; i < count; ++i) {
    EXPECT_NEAR(samples.weights.row(i).sum(), 1.0, 1e-12);
    EXPECT_GE(samples.weights.row(i).minCoeff(), 0.0);
    for (Eigen::Index k = 0; k < i; ++k) {
      EXPECT_GT((samples.parameters.row(i) - samples.parameters.row(k)).norm(), 0.2);
    }
  }
}

TEST(NearestNeighbours, MeasureWhatABlendReallyIs) {
  const auto bent = [&](const Eigen::VectorXd& weights) -> Eigen::RowVectorXd {
    return (weights.transpose() * corners).array().square();
  };
  const NearestNeighbours samples = fit_nearest_neighbours(corners, {.trials = 50}, bent);
  ASSERT_GT(samples.parameters.rows(), 4);
  for (Eigen::Index i = 4; i < samples.parameters.rows(); ++i) {
    EXPECT_LT((samples.parameters.row(i) - bent(samples.weights.row(i).transpose())).norm(), 1e-14);
  }
}

TEST(NearestNeighbours, DrawOtherBlendsForAnotherSeed) {
  const auto fitted = [](std::uint64_t seed) {
    return fit_nearest_neighbours(corners, {.trials = 20, .seed = seed});
  };
  EXPECT_EQ(fitted(1).weights, fitted(1).weights);
  EXPECT_NE(fitted(1).weights.row(4), fitted(2).weights.row(4));
}

TEST(InverseDistance, IsShepards) {
  const Eigen::VectorXd found =
      inverse_distance_weights(corners.topRows(2), Eigen::RowVector2d(0.25, 0.0), 2.0);
  EXPECT_NEAR(found[0], 16.0 / (16.0 + 16.0 / 9.0), 1e-14);
  // No power is too high for a number.
  EXPECT_NEAR(inverse_distance_weights(corners, Eigen::RowVector2d(1e-6, 0.0), 100.0)[0], 1.0,
              1e-12);
}

}  // namespace
}  // namespace mien::motion
