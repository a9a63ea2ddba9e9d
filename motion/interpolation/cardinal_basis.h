#pragma once

#include <Eigen/Core>

#include "motion/interpolation/parameter_table.h"

namespace mien::motion {

/// Cubic B-spline as a function of distance in units of half its support radius: B(0) = 2/3, B(1) =
/// 1/6, B(x ≥ 2) = 0.
double cubic_b_spline(double x);

/// Weights of the examples as functions of the parameters: w_i(p_k) = δ_ik, and Σ w_i = 1
/// everywhere (eq. (7) of the adjective paper; Rose et al. 1998, Sloan et al. 2001). The sum of a
/// linear least-squares part and a radial part of cubic B-splines that interpolates its residual.
struct CardinalBasis {
  DistinctParameters distinct;  ///< the centres: distinct parameters of the examples (K × M)
  Eigen::RowVectorXd mean;      ///< subtracted from parameters before the linear part (M)
  Eigen::MatrixXd linear;       ///< K × (M+1): constant, then one column per parameter
  Eigen::MatrixXd radial;       ///< K × K: r_ik
  Eigen::VectorXd widths;       ///< α_k: half the support radius of radial function k
  int halvings = 0;  ///< number of times the widths were halved to keep the system solvable
};

/// Fits the basis to the parameters of the examples (one row per example, N × M, N ≥ 1). For
/// collinear examples, or more parameters than examples, the linear part is the minimum-norm
/// solution. Examples closer than 1e-6 share one centre, and share its weight equally.
CardinalBasis fit_cardinal_basis(const Eigen::MatrixXd& example_parameters);

/// Weights of the examples at given parameters, before clipping: they sum to 1 but may lie outside
/// [0, 1].
Eigen::VectorXd raw_weights(const CardinalBasis& basis, const Eigen::RowVectorXd& parameters);

/// `raw_weights` clipped to [0, 1] and normalised: the weights for blending motions.
Eigen::VectorXd weights(const CardinalBasis& basis, const Eigen::RowVectorXd& parameters);

/// The weights clipped to [0, 1] and divided by their sum, which must not be zero.
Eigen::VectorXd clipped_and_normalised(Eigen::VectorXd weights);

}  // namespace mien::motion
