#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace mien::motion {

// Systems of linear equations. Eigen's decompositions are compiled here once, and not in each file
// that solves something.

/// A square matrix taken apart, to solve many systems with it: LU with partial pivoting.
class LinearSystem {
 public:
  LinearSystem() = default;
  explicit LinearSystem(const Eigen::MatrixXd& matrix);

  /// x where matrix · x = right.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// The same for each column of `right`.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

  /// 1 of the identity; towards 0 the nearer the matrix is to a singular one.
  double reciprocal_condition() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// X where matrix · X = right, of a symmetric positive semi-definite matrix (LDLᵀ).
Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The inverse of a symmetric positive definite matrix (LLᵀ).
Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix);

}  // namespace mien::motion
