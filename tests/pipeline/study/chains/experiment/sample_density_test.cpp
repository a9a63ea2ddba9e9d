#include "pipeline/study/chains/experiment/sample_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double integral(const SampleDensity& of) {
  double sum = 0.0;
  for (std::size_t i = 1; i < of.places.size(); ++i)
    sum += 0.5 * (of.density[i] + of.density[i - 1]) * (of.places[i] - of.places[i - 1]);
  return sum;
}

double normal_density(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
}

TEST(SampleDensity, IsThatOfTheDistributionSampledFrom) {
  std::vector<double> samples;
  for (std::uint64_t i = 0; i < 20000; ++i) samples.push_back(normal_number(5, i));
  std::erase_if(samples, [](double x) { return std::abs(x) > 5.0; });
  const SampleDensity of = sample_density(samples, unknown, {-5.0, 5.0});
  ASSERT_EQ(of.places.size(), 101u);
  EXPECT_EQ(of.places.front(), -5.0);
  EXPECT_EQ(of.places.back(), 5.0);
  EXPECT_NEAR(integral(of), 1.0, 1e-9);
  for (std::size_t i = 0; i < of.places.size(); ++i)
    EXPECT_NEAR(of.density[i], normal_density(of.places[i]), 0.02) << of.places[i];
}

TEST(SampleDensity, IsFlatUpToTheEndsOfTheRange) {
  std::vector<double> samples;
  for (int i = 0; i < 4000; ++i) samples.push_back(2.0 + 3.0 * (i + 0.5) / 4000.0);
  const SampleDensity of = sample_density(samples, unknown, {2.0, 5.0});
  for (const double density : of.density) EXPECT_NEAR(density, 1.0 / 3.0, 0.01);
}

TEST(SampleDensity, OfOneValueIsNarrowAndOfFewerIndependentOnesWider) {
  const SampleDensity one = sample_density({0.5}, unknown, {0.0, 1.0});
  EXPECT_NEAR(integral(one), 1.0, 1e-9);
  EXPECT_EQ(std::ranges::max_element(one.density) - one.density.begin(), 50);
  EXPECT_GT(one.density[50], 30.0);
  const SampleDensity end = sample_density({0.0, 0.0}, unknown, {0.0, 1.0});
  EXPECT_NEAR(integral(end), 1.0, 1e-9);
  EXPECT_EQ(std::ranges::max_element(end.density) - end.density.begin(), 0);
  std::vector<double> samples;
  for (std::uint64_t i = 0; i < 500; ++i)
    samples.push_back(0.5 + 0.1 * std::clamp(normal_number(9, i), -4.0, 4.0));
  EXPECT_LT(std::ranges::max(sample_density(samples, 5.0, {0.0, 1.0}).density),
            std::ranges::max(sample_density(samples, unknown, {0.0, 1.0}).density));
}

TEST(SamplePlane, HasTheDirectionsInWhichSamplesVaryMost) {
  // Along (3, −4, 0)/5 with deviation 2, along z with 1, else none.
  Eigen::MatrixXd samples(3, 4);
  samples << 1.2, -1.2, 0.0, 0.0,  //
      -1.6, 1.6, 0.0, 0.0,         //
      0.0, 0.0, 1.0, -1.0;
  samples.colwise() += Eigen::Vector3d(5.0, 6.0, 7.0);
  const SamplePlane plane = sample_plane(samples);
  EXPECT_TRUE(plane.centre.isApprox(Eigen::Vector3d(5.0, 6.0, 7.0)));
  EXPECT_TRUE(plane.axes.col(0).isApprox(Eigen::Vector3d(-0.6, 0.8, 0.0)));
  EXPECT_TRUE(plane.axes.col(1).isApprox(Eigen::Vector3d(0.0, 0.0, 1.0)));
  EXPECT_NEAR(plane.shares[0], 0.8, 1e-12);
  EXPECT_NEAR(plane.shares[1], 0.2, 1e-12);
  EXPECT_TRUE(plane.at(samples.col(0)).isApprox(Eigen::Vector2d(-2.0, 0.0), 1e-9));
  // Samples that do not vary.
  const SamplePlane none = sample_plane(Eigen::MatrixXd::Constant(2, 3, 0.5));
  EXPECT_EQ(none.shares[0], 0.0);
}

TEST(DensityMap, IsHighWherePointsAreAndHasTheIntegralOne) {
  Eigen::Matrix2Xd points(2, 6000);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) << 1.0 + 0.1 * normal_number(1, static_cast<std::uint64_t>(i)),
        -1.0 + 0.2 * normal_number(2, static_cast<std::uint64_t>(i));
  const DensityMap map = density_map(points, -2.0, -2.0, 4.0, 80);
  EXPECT_NEAR(map.density.sum() * 0.05 * 0.05, 1.0, 1e-9);
  Eigen::Index row = 0, column = 0;
  map.density.maxCoeff(&row, &column);
  EXPECT_NEAR(-2.0 + 0.05 * (static_cast<double>(column) + 0.5), 1.0, 0.08);
  EXPECT_NEAR(-2.0 + 0.05 * (static_cast<double>(row) + 0.5), -1.0, 0.15);
  // The variance of a kernel estimate is that of the points and of the kernel: n^(−1/3) of it more.
  double mean = 0.0, square = 0.0;
  for (Eigen::Index r = 0; r < 80; ++r) {
    const double y = -2.0 + 0.05 * (static_cast<double>(r) + 0.5);
    const double share = map.density.row(r).sum() * 0.05 * 0.05;
    mean += share * y;
    square += share * y * y;
  }
  EXPECT_NEAR(std::sqrt(square - mean * mean), 0.2 * std::sqrt(1.0 + std::pow(6000.0, -1.0 / 3.0)),
              0.01);
}

}  // namespace
}  // namespace mien::pipeline
