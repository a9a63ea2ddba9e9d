#include "motion/math/linear_system.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace mien::motion {

LinearSystem::LinearSystem(const Eigen::MatrixXd& matrix) : factors_(matrix) {}

Eigen::VectorXd LinearSystem::solve(const Eigen::VectorXd& right) const {
  return factors_.solve(right);
}

Eigen::MatrixXd LinearSystem::solve_columns(const Eigen::MatrixXd& right) const {
  return factors_.solve(right);
}

double LinearSystem::reciprocal_condition() const { return factors_.rcond(); }

Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  // Of nothing Eigen would take a reference.
  if (right.size() == 0) return Eigen::MatrixXd::Zero(matrix.cols(), right.cols());
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix) {
  return matrix.llt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& rows) {
  const Eigen::MatrixXd basis =
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(rows.transpose()).householderQ();
  return basis.rightCols(rows.cols() - rows.rows());
}

}  // namespace mien::motion
