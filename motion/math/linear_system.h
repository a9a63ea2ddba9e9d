#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace mien::motion {

// Systems of linear equations. Wrapping Eigen's decompositions compiles them once instead of in
// every file that uses them.

/// A factorised square matrix (LU with partial pivoting), for solving several systems with it.
class LinearSystem {
 public:
  LinearSystem() = default;
  explicit LinearSystem(const Eigen::MatrixXd& matrix);

  /// The solution x of matrix · x = right.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// `solve` for each column of `right`.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

  /// Reciprocal condition number: 1 for the identity, near 0 for nearly singular matrices.
  double reciprocal_condition() const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// The solution X of matrix · X = right for a symmetric positive semi-definite matrix (LDLᵀ).
Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The inverse of a symmetric positive definite matrix (LLᵀ).
Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix);

/// An x that minimizes |matrix · x − right| (QR with column pivoting); it is one of several if the
/// columns of the matrix are linearly dependent.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// An orthonormal basis, as columns, of all x with rows · x = 0. The rows must be linearly
/// independent and no more numerous than the columns.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& rows);

}  // namespace mien::motion
