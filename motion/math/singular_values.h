#pragma once

#include <Eigen/Core>

namespace mien::motion {

/// The singular value decomposition u · diag(values) · vᵀ of a matrix; the columns of u and of v
/// are orthonormal. The number of values is that of the matrix's rows or columns, whichever is
/// smaller.
struct SingularValues {
  Eigen::MatrixXd u;
  Eigen::VectorXd values;  ///< descending, ≥ 0
  Eigen::MatrixXd v;

  /// Numerical rank: the number of values above `share` of the largest; 0 for a zero matrix.
  Eigen::Index rank(double share) const;

  /// The minimum-norm least-squares solution X of A X = right. Singular values below the threshold
  /// of rank(share) are treated as zero.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right, double share) const;
};

SingularValues singular_values(const Eigen::MatrixXd& matrix);

/// A unit vector perpendicular to both vectors, which may be parallel.
Eigen::Vector3d perpendicular_to(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace mien::motion
