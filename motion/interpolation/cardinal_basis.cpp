#include "motion/interpolation/cardinal_basis.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "motion/math/linear_system.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

double cubic_b_spline(double x) {
  if (x <= 1.0) return (4.0 - 6.0 * x * x + 3.0 * x * x * x) / 6.0;
  if (x < 2.0) return (2.0 - x) * (2.0 - x) * (2.0 - x) / 6.0;
  return 0.0;
}

namespace {

constexpr double largest_condition = 1e8;

/// Least squares of [1 P]·lᵀ ≈ I on centred parameters. The constant alone is the mean of the
/// targets because the columns of P sum to zero, so only the slopes need the minimum-norm solution.
Eigen::MatrixXd fit_linear(const Eigen::MatrixXd& centred) {
  const auto count = centred.rows();
  const Eigen::MatrixXd targets = Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd linear(count, centred.cols() + 1);
  linear.col(0).setConstant(1.0 / static_cast<double>(count));
  if (centred.cols() == 0) return linear;
  linear.rightCols(centred.cols()) =
      singular_values(centred).solve(targets, singular_share).transpose();
  return linear;
}

Eigen::VectorXd nearest_distances(const Eigen::MatrixXd& centres) {
  Eigen::VectorXd nearest(centres.rows());
  for (int k = 0; k < centres.rows(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (int m = 0; m < centres.rows(); ++m) {
      if (m != k) least = std::min(least, (centres.row(m) - centres.row(k)).norm());
    }
    nearest[k] = std::isfinite(least) ? least : 1.0;
  }
  return nearest;
}

Eigen::MatrixXd radial_matrix(const Eigen::MatrixXd& centres, const Eigen::VectorXd& widths) {
  Eigen::MatrixXd phi(centres.rows(), centres.rows());
  for (int m = 0; m < centres.rows(); ++m) {
    for (int k = 0; k < centres.rows(); ++k) {
      phi(m, k) = cubic_b_spline((centres.row(m) - centres.row(k)).norm() / widths[k]);
    }
  }
  return phi;
}

}  // namespace

CardinalBasis fit_cardinal_basis(const Eigen::MatrixXd& example_parameters) {
  assert(example_parameters.rows() > 0);
  CardinalBasis basis;
  basis.distinct = distinct_parameters(example_parameters);
  const Eigen::MatrixXd& centres = basis.distinct.places;
  const auto count = centres.rows();
  basis.mean = centres.colwise().mean();
  const Eigen::MatrixXd centred = centres.rowwise() - basis.mean;
  basis.linear = fit_linear(centred);

  Eigen::MatrixXd design(count, centred.cols() + 1);
  design << Eigen::VectorXd::Ones(count), centred;
  const Eigen::MatrixXd residual =
      Eigen::MatrixXd::Identity(count, count) - design * basis.linear.transpose();

  basis.widths = nearest_distances(centres);
  LinearSystem system(radial_matrix(centres, basis.widths));
  while (system.reciprocal_condition() < 1.0 / largest_condition) {
    basis.widths *= 0.5;
    ++basis.halvings;
    system = LinearSystem(radial_matrix(centres, basis.widths));
  }
  basis.radial = system.solve_columns(residual).transpose();
  return basis;
}

Eigen::VectorXd raw_weights(const CardinalBasis& basis, const Eigen::RowVectorXd& parameters) {
  const Eigen::MatrixXd& centres = basis.distinct.places;
  assert(parameters.size() == centres.cols());
  Eigen::VectorXd affine(parameters.size() + 1);
  affine << 1.0, (parameters - basis.mean).transpose();
  Eigen::VectorXd radial(centres.rows());
  for (Eigen::Index k = 0; k < radial.size(); ++k) {
    radial[k] = cubic_b_spline((parameters - centres.row(k)).norm() / basis.widths[k]);
  }
  return by_example(basis.distinct, basis.linear * affine + basis.radial * radial);
}

Eigen::VectorXd clipped_and_normalised(Eigen::VectorXd weights) {
  weights = weights.cwiseMax(0.0).cwiseMin(1.0);
  assert(weights.sum() > 0.0);
  return weights / weights.sum();
}

Eigen::VectorXd weights(const CardinalBasis& basis, const Eigen::RowVectorXd& parameters) {
  return clipped_and_normalised(raw_weights(basis, parameters));
}

}  // namespace mien::motion
