#pragma once

#include <Eigen/Core>

namespace mien::motion {

/// An x ≥ 0 for which |A x − b| is least (Lawson & Hanson, Solving Least Squares Problems, 1974,
/// chapter 23). The columns of A at which x is not 0 are linearly independent.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

// Convex weights of points (≥ 0, sum 1) for a given weighted mean.

/// Weights whose mean of the points (columns of a D × N matrix) lies nearest to `target`: on it
/// where it lies within their convex hull. As many weights as D + 1 are above 0 at most. The mean
/// follows the target continuously; the weights need not.
Eigen::VectorXd weights_nearest_to(const Eigen::MatrixXd& points, const Eigen::VectorXd& target);

/// Among weights that have the same mean of the points as `start` has, those for which
/// |C w − d| is least. The columns of C are linearly independent, so there is one answer only; it
/// follows the mean and d continuously. An active set method for a convex quadratic programme
/// (Nocedal & Wright, Numerical Optimization, 2006, algorithm 16.3), from the feasible `start`,
/// which comes from weights_nearest_to.
Eigen::VectorXd least_squares_at_mean(const Eigen::MatrixXd& points, const Eigen::VectorXd& start,
                                      const Eigen::MatrixXd& c, const Eigen::VectorXd& d);

}  // namespace mien::motion
