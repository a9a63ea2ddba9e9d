#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// A C² cubic spline through knots.
struct CubicSpline {
  std::vector<double> times;  ///< ascending
  Eigen::MatrixXd values;     ///< knots × curves
  Eigen::MatrixXd slopes;     ///< knots × curves
};

/// Level at both ends (slope zero), so that it continues a constant. At least 2 knots.
CubicSpline level_spline(std::vector<double> times, const Eigen::MatrixXd& values);

/// Through knots that repeat after `period` (which exceeds the distance of the last knot from the
/// first): the first knot is given once. At least 1 knot.
CubicSpline periodic_spline(std::vector<double> times, const Eigen::MatrixXd& values,
                            double period);

/// Values of the spline at a time, clamped to its ends.
Eigen::RowVectorXd at_time(const CubicSpline& spline, double time);

}  // namespace mien::motion
