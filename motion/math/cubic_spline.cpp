#include "motion/math/cubic_spline.h"

#include <algorithm>
#include <utility>

#include "motion/math/linear_system.h"

namespace mien::motion {

namespace {

/// The condition that curvature does not jump at a knot, for the slopes of it and its neighbours.
struct Continuity {
  double before = 0.0;
  double here = 0.0;
  double after = 0.0;
  Eigen::RowVectorXd right;
};

Continuity continuity(const Eigen::RowVectorXd& previous, const Eigen::RowVectorXd& value,
                      const Eigen::RowVectorXd& next, double width_before, double width_after) {
  const double p = 1.0 / width_before;
  const double q = 1.0 / width_after;
  return {p, 2.0 * (p + q), q, 3.0 * (p * p * (value - previous) + q * q * (next - value))};
}

}  // namespace

CubicSpline level_spline(std::vector<double> times, const Eigen::MatrixXd& values) {
  const auto knots = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(knots, knots);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(knots, values.cols());
  for (Eigen::Index k = 1; k + 1 < knots; ++k) {
    const Continuity smooth = continuity(values.row(k - 1), values.row(k), values.row(k + 1),
                                         times[k] - times[k - 1], times[k + 1] - times[k]);
    system(k, k - 1) = smooth.before;
    system(k, k) = smooth.here;
    system(k, k + 1) = smooth.after;
    right.row(k) = smooth.right;
  }
  return {std::move(times), values, LinearSystem(system).solve_columns(right)};
}

CubicSpline periodic_spline(std::vector<double> times, const Eigen::MatrixXd& values,
                            double period) {
  const auto knots = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(knots, knots);
  Eigen::MatrixXd right(knots, values.cols());
  for (Eigen::Index k = 0; k < knots; ++k) {
    const Eigen::Index before = (k + knots - 1) % knots;
    const Eigen::Index after = (k + 1) % knots;
    const double width_before = times[k] - times[before] + (k == 0 ? period : 0.0);
    const double width_after = times[after] - times[k] + (after == 0 ? period : 0.0);
    const Continuity smooth =
        continuity(values.row(before), values.row(k), values.row(after), width_before, width_after);
    system(k, before) += smooth.before;
    system(k, k) += smooth.here;
    system(k, after) += smooth.after;
    right.row(k) = smooth.right;
  }
  const Eigen::MatrixXd slopes = LinearSystem(system).solve_columns(right);
  CubicSpline spline{std::move(times), Eigen::MatrixXd(knots + 1, values.cols()),
                     Eigen::MatrixXd(knots + 1, values.cols())};
  spline.times.push_back(spline.times.front() + period);
  spline.values << values, values.row(0);
  spline.slopes << slopes, slopes.row(0);
  return spline;
}

Eigen::RowVectorXd at_time(const CubicSpline& spline, double time) {
  if (time <= spline.times.front()) return spline.values.row(0);
  if (time >= spline.times.back()) return spline.values.bottomRows<1>();
  const auto next = std::upper_bound(spline.times.begin(), spline.times.end(), time);
  const auto k = next - spline.times.begin() - 1;
  const double width = spline.times[k + 1] - spline.times[k];
  const double s = (time - spline.times[k]) / width;
  const Eigen::RowVectorXd rise = spline.values.row(k + 1) - spline.values.row(k);
  return spline.values.row(k) + s * rise +
         s * (1.0 - s) *
             ((1.0 - s) * (width * spline.slopes.row(k) - rise) -
              s * (width * spline.slopes.row(k + 1) - rise));
}

Vec3 catmull_rom(const Vec3& before, const Vec3& from, const Vec3& to, const Vec3& after,
                 double t) {
  const Vec3 a = 2.0 * from;
  const Vec3 b = to - before;
  const Vec3 c = 2.0 * before - 5.0 * from + 4.0 * to - after;
  const Vec3 d = 3.0 * (from - to) + after - before;
  return 0.5 * (a + t * (b + t * (c + t * d)));
}

}  // namespace mien::motion
