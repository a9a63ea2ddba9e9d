#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace mien::motion {

// Systems of linear equations. Eigen's decompositions are compiled here once, and not in each file
// that solves something.

/// A factorised square matrix (LU with partial pivoting), to solve many systems with it.
class LinearSystem {
 public:
  LinearSystem() = default;
  explicit LinearSystem(const Eigen::MatrixXd& matrix);

  /// x where matrix · x = right.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// `solve` for each column of `right`.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

  /// Reciprocal condition number: 1 for the identity, near 0 for nearly singular matrices.
  double reciprocal_condition() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// X where matrix · X = right, of a symmetric positive semi-definite matrix (LDLᵀ).
Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The inverse of a symmetric positive definite matrix (LLᵀ).
Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix);

/// The x for which |matrix · x − right| is least (QR with column pivoting); of a matrix whose
/// columns depend on each other one of them.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Orthonormal columns that span all x with rows · x = 0, where the rows, no more than there are
/// columns, do not depend on each other.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& rows);

}  // namespace mien::motion
