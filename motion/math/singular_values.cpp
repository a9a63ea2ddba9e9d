#include "motion/math/singular_values.h"

#include <algorithm>
#include <limits>

#include <Eigen/SVD>

namespace mien::motion {

Eigen::Index SingularValues::rank(double share) const {
  if (values.size() == 0) return 0;
  const double least = std::max(share * values[0], std::numeric_limits<double>::min());
  return (values.array() > least).count();
}

Eigen::MatrixXd SingularValues::solve(const Eigen::MatrixXd& right, double share) const {
  const Eigen::Index kept = rank(share);
  const Eigen::MatrixXd along = u.leftCols(kept).transpose() * right;
  const Eigen::VectorXd inverse = values.head(kept).cwiseInverse();
  return v.leftCols(kept) * (inverse.asDiagonal() * along);
}

SingularValues singular_values(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) {
    return {Eigen::MatrixXd(matrix.rows(), 0), Eigen::VectorXd(0),
            Eigen::MatrixXd(matrix.cols(), 0)};
  }
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::Vector3d perpendicular_to(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Eigen::MatrixXd rows(2, 3);
  rows << a.transpose(), b.transpose();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(rows, Eigen::ComputeFullV).matrixV().col(2);
}

}  // namespace mien::motion
