#pragma once

#include <Eigen/Core>

namespace mien::motion {

/// A matrix as u · diag(values) · vᵀ, where the columns of u, and those of v, are orthonormal.
/// As many values as the matrix has rows or columns, whichever are fewer.
struct SingularValues {
  Eigen::MatrixXd u;
  Eigen::VectorXd values;  ///< descending, none negative
  Eigen::MatrixXd v;

  /// Numerical rank: the number of values above `share` of the largest; 0 for a zero matrix.
  Eigen::Index rank(double share) const;

  /// The X for which |A X − right| is least, of those the smallest. Values that do not count for
  /// rank(share) are taken for zero.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right, double share) const;
};

SingularValues singular_values(const Eigen::MatrixXd& matrix);

/// A unit vector at right angles to both, which may be parallel.
Eigen::Vector3d perpendicular_to(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace mien::motion
