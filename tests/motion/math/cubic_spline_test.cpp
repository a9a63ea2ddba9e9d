#include "motion/math/cubic_spline.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(CubicSpline, BetweenLevelKnotsIsTheSmoothStep) {
  // Level ends, knots 0, 1, 2 with values 0, 1, 0: slopes 0, 0, 0, the curve 3s² − 2s³.
  Eigen::MatrixXd values(3, 1);
  values << 0.0, 1.0, 0.0;
  const CubicSpline spline = level_spline({0.0, 1.0, 2.0}, values);
  EXPECT_NEAR(spline.slopes(1, 0), 0.0, 1e-15);
  EXPECT_NEAR(at_time(spline, 0.25)(0), 3.0 / 16.0 - 2.0 / 64.0, 1e-15);
}

TEST(CubicSpline, HasNoJumpOfCurvature) {
  Eigen::MatrixXd values(5, 2);
  values << 0, 1, 2, -1, 0.5, 0.3, -1, 2, 0, 0;
  const std::vector<double> times = {0.0, 0.4, 1.1, 1.5, 2.5};
  for (const CubicSpline& spline :
       {level_spline(times, values), periodic_spline(times, values, 3.2)}) {
    for (size_t k = 1; k + 1 < spline.times.size(); ++k) {
      const double h = 1e-4;
      const double t = spline.times[k];
      const auto curvature = [&](double at) -> Eigen::RowVectorXd {
        return (at_time(spline, at - h) - 2.0 * at_time(spline, at) + at_time(spline, at + h)) /
               (h * h);
      };
      EXPECT_LT((curvature(t - 2 * h) - curvature(t + 2 * h)).cwiseAbs().maxCoeff(), 0.1);
      EXPECT_EQ(at_time(spline, t), spline.values.row(static_cast<Eigen::Index>(k)));
    }
  }
}

TEST(PeriodicSpline, IsNearASine) {
  const int knots = 12;
  std::vector<double> times;
  Eigen::MatrixXd values(knots, 1);
  for (int k = 0; k < knots; ++k) {
    times.push_back(k);
    values(k, 0) = std::sin(2.0 * M_PI * k / knots);
  }
  const CubicSpline spline = periodic_spline(times, values, knots);
  for (double t = 0.0; t < knots; t += 0.1) {
    EXPECT_NEAR(at_time(spline, t)(0), std::sin(2.0 * M_PI * t / knots), 2e-3) << t;
  }
  EXPECT_NEAR(spline.slopes(0, 0), 2.0 * M_PI / knots, 2e-3);
}

}  // namespace
}  // namespace mien::motion
