#pragma once

#include <Eigen/Core>

namespace mien::motion {

/// An x ≥ 0 for which |A x − b| is least (Lawson & Hanson, Solving Least Squares Problems, 1974,
/// chapter 23). The columns of A at which x is not 0 are linearly independent.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace mien::motion
