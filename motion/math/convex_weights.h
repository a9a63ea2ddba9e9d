#pragma once

#include <Eigen/Core>

namespace mien::motion {

/// Returns an x ≥ 0 that minimizes |A x − b| (Lawson & Hanson, Solving Least Squares Problems,
/// 1974, chapter 23). The columns of A for which x is not 0 are linearly independent.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

// Convex weights of points (≥ 0, sum 1) that yield a given weighted mean.

/// Weights whose weighted mean of the points (columns of a D × N matrix) lies nearest to `target`.
/// A target within the convex hull of the points is met exactly. At most D + 1 weights are above 0.
/// The mean is a continuous function of the target; the weights need not be.
Eigen::VectorXd weights_nearest_to(const Eigen::MatrixXd& points, const Eigen::VectorXd& target);

/// The convex weights w that minimize |C w − d| and give the points the same weighted mean as
/// `start` does. The columns of C must be linearly independent, so the solution is unique; it is a
/// continuous function of the mean and of d. An active-set method for convex quadratic programming
/// (Nocedal & Wright, Numerical Optimization, 2006, algorithm 16.3), starting from the feasible
/// `start`, a result of weights_nearest_to.
Eigen::VectorXd least_squares_at_mean(const Eigen::MatrixXd& points, const Eigen::VectorXd& start,
                                      const Eigen::MatrixXd& c, const Eigen::VectorXd& d);

}  // namespace mien::motion
