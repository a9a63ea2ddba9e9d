#include "motion/style_transfer/iterative_motion_warping.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/math/dynamic_time_warp.h"

namespace mien::motion {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Four different signals over the share of a motion.
Eigen::RowVectorXd signals_at(double share) {
  Eigen::RowVectorXd signals(4);
  signals << std::sin(2 * pi * share), 0.5 * std::cos(2 * pi * share + 0.4),
      0.3 * std::sin(4 * pi * share) + 0.4 * std::sin(2 * pi * share + 1.0),
      0.6 * std::cos(4 * pi * share);
  return signals;
}

/// Ascending from 0 to 1 with a slope between 0.62 and 1.38.
double uneven(double share) { return share + 0.06 * std::sin(2 * pi * share); }

Eigen::MatrixXd sampled(int rows, double (*time)(double)) {
  Eigen::MatrixXd result(rows, 4);
  for (int i = 0; i < rows; ++i) {
    result.row(i) = signals_at(time(static_cast<double>(i) / (rows - 1)));
  }
  return result;
}

double even(double share) { return share; }

TEST(DynamicTimeWarp, OfASignalToItselfIsTheDiagonal) {
  const Eigen::MatrixXd signals = sampled(60, even);
  const std::vector<double> path = dynamic_time_warp(signals, signals);
  for (int i = 0; i < 60; ++i) EXPECT_EQ(path[i], i);
}

TEST(DynamicTimeWarp, FindsAnUnevenPace) {
  // from(i) = signals at uneven(i): the row of the even ones is uneven(i) itself.
  for (const int rows : {80, 130, 200}) {
    const std::vector<double> path = dynamic_time_warp(sampled(100, uneven), sampled(rows, even));
    for (int i = 0; i < 100; ++i) {
      EXPECT_NEAR(path[i] / (rows - 1), uneven(i / 99.0), 0.015) << rows << " " << i;
      if (i > 0) {
        EXPECT_GE(path[i] - path[i - 1], 0.5 * (rows - 1) / 99.0 - 1e-9);
        EXPECT_LE(path[i] - path[i - 1], 2.0 * (rows - 1) / 99.0 + 1e-9);
      }
    }
    EXPECT_DOUBLE_EQ(path.back(), rows - 1);
  }
}

TEST(DynamicTimeWarp, IsNoWorseThanRandomPaths) {
  std::mt19937 random(4);
  const Eigen::MatrixXd from = sampled(12, uneven);
  const Eigen::MatrixXd to = sampled(12, even);
  const auto cost = [&](const std::vector<double>& path) {
    return (from - rows_at(to, path)).squaredNorm();
  };
  const double least = cost(dynamic_time_warp(from, to));
  int tried = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<double> path = {0.0};
    while (path.size() < 12 && path.back() < 11.0) {
      const auto step = random() % 3;
      if (step == 2) path.push_back(path.back() + 0.5);
      path.push_back(path.back() + (step == 0 ? 1.0 : step == 1 ? 2.0 : 0.5));
    }
    if (path.size() != 12 || path.back() != 11.0) continue;
    ++tried;
    EXPECT_GE(cost(path), least - 1e-12);
  }
  EXPECT_GT(tried, 100);
}

TEST(IterativeMotionWarping, RecoversTimeWarpScaleAndOffset) {
  const Eigen::RowVector4d scale(1.4, 0.6, 1.2, 0.8);
  const Eigen::RowVector4d offset(0.3, -0.2, 0.1, 0.0);
  const Eigen::MatrixXd input = sampled(100, uneven);
  const Eigen::MatrixXd even_output = sampled(120, even);
  const Eigen::MatrixXd output =
      (even_output.array().rowwise() * scale.array()).rowwise() + offset.array();
  const MotionCorrespondence found =
      iterative_motion_warping(input, output, {.smoothness = 1e6, .most_iterations = 200});
  EXPECT_TRUE(found.converged);
  EXPECT_LT(found.error, 0.02);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(found.times[i] / 119.0, uneven(i / 99.0), 0.025) << i;
    EXPECT_LT((found.scale.row(i) - scale).cwiseAbs().maxCoeff(), 0.1) << i;
    EXPECT_LT((found.offset.row(i) - offset).cwiseAbs().maxCoeff(), 0.05) << i;
  }
}

TEST(IterativeMotionWarping, StopsWhenTheErrorStandsStill) {
  const Eigen::MatrixXd input = sampled(60, even);
  const Eigen::MatrixXd output = (1.3 * sampled(60, uneven)).array() + 0.2;
  MotionCorrespondence last = iterative_motion_warping(input, output);
  ASSERT_TRUE(last.converged);
  const MotionCorrespondence before =
      iterative_motion_warping(input, output, {.most_iterations = last.iterations - 1});
  EXPECT_FALSE(before.converged);
  EXPECT_LE(std::abs(before.error - last.error), 1e-4 * before.error);
}

TEST(IterativeMotionWarping, OfAMotionToItselfIsTheIdentity) {
  const Eigen::MatrixXd input = sampled(60, even);
  const MotionCorrespondence found = iterative_motion_warping(input, input);
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.error, 0.0);
  EXPECT_EQ(found.scale, Eigen::MatrixXd::Ones(60, 4));
  EXPECT_EQ(found.offset, Eigen::MatrixXd::Zero(60, 4));
}

}  // namespace
}  // namespace mien::motion
