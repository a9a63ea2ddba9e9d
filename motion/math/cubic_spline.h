#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/math/geometry.h"

namespace mien::motion {

/// A C² cubic spline through knots, in Hermite form.
struct CubicSpline {
  std::vector<double> times;  ///< ascending
  Eigen::MatrixXd values;     ///< knots × curves
  Eigen::MatrixXd slopes;     ///< knots × curves
};

/// The spline with zero slope at both ends, so that it joins constants there. At least 2 knots.
CubicSpline level_spline(std::vector<double> times, const Eigen::MatrixXd& values);

/// The periodic spline through the knots, which repeat after `period`. The period is longer than
/// the time from the first knot to the last: the arguments do not repeat the first knot at the end.
/// The result does. At least 1 knot.
CubicSpline periodic_spline(std::vector<double> times, const Eigen::MatrixXd& values,
                            double period);

/// Values of all curves at a time, which is clamped to the range of the knots.
Eigen::RowVectorXd at_time(const CubicSpline& spline, double time);

/// The Catmull–Rom spline at `t` in [0, 1] between `from` and `to`, whose neighbours at equal
/// distances in time are `before` and `after`.
Vec3 catmull_rom(const Vec3& before, const Vec3& from, const Vec3& to, const Vec3& after, double t);

}  // namespace mien::motion
