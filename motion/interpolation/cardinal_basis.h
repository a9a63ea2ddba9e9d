#pragma once

#include <Eigen/Core>

#include "motion/interpolation/parameter_table.h"

namespace mien::motion {

/// Cubic B-spline of a distance in units of its half support: B(0) = 2/3, B(1) = 1/6, B(x ≥ 2) = 0.
double cubic_b_spline(double x);

/// Weights of examples as functions of parameters: w_i(p_k) = δ_ik, Σ w_i = 1 everywhere (eq. (7)
/// of the adjective paper; Rose et al. 1998, Sloan et al. 2001). A linear least-squares part and a
/// radial part of cubic B-splines that takes up its residual.
struct CardinalBasis {
  DistinctParameters distinct;  ///< the centres: places of the examples (K × M)
  Eigen::RowVectorXd mean;      ///< taken from parameters before the linear part (M)
  Eigen::MatrixXd linear;       ///< K × (M+1): constant, then one column a parameter
  Eigen::MatrixXd radial;       ///< K × K: r_ik
  Eigen::VectorXd widths;       ///< α_k: half the support of radial function k
  int halvings = 0;             ///< how often the widths were halved to stay solvable
};

/// Fits the basis to the examples' parameters (one row an example, N × M, N ≥ 1). Collinear
/// examples and more parameters than examples are covered by the minimum-norm linear part; examples
/// nearer than 1e-6 share one centre and, equally, its weight.
CardinalBasis fit_cardinal_basis(const Eigen::MatrixXd& example_parameters);

/// Weights at parameters p as the basis gives them (may lie outside [0, 1]; sum to 1).
Eigen::VectorXd raw_weights(const CardinalBasis& basis, const Eigen::RowVectorXd& parameters);

/// `raw_weights` clipped to [0, 1] and normalised: the weights with which motions are blended.
Eigen::VectorXd weights(const CardinalBasis& basis, const Eigen::RowVectorXd& parameters);

/// The weights clipped to [0, 1] and divided by their sum, which must not be zero.
Eigen::VectorXd clipped_and_normalised(Eigen::VectorXd weights);

}  // namespace mien::motion
