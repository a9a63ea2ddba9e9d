#pragma once

#include <Eigen/Core>

#include "motion/interpolation/cardinal_basis.h"

namespace mien::motion {

/// Weights that meet the requested parameters exactly where possible. Of all weights w ≥ 0 with Σ w
/// = 1 whose weighted mean of parameters equals the request, those nearest to the weights of the
/// cardinal basis are chosen; if there are none, those with the smallest deviation from the
/// request. Related to inverse blending (Huang & Kallmann 2010), which adjusts weights until a
/// constraint on the pose is satisfied. The weights are continuous functions of the parameters.
///
/// Parameters may also be held: among weights that meet the requested parameters, those with the
/// smallest deviation of the held parameters are preferred.
struct Reach {
  CardinalBasis basis;        ///< of the requested parameters only
  Eigen::MatrixXd asked;      ///< requested parameters of the examples: one row per parameter, one
                              ///< column per example
  Eigen::MatrixXd held_rows;  ///< held parameters of the examples, in the same layout
};

/// Fits the method. `places` holds the parameters of the examples, one row each: the requested
/// parameters first, then the `held` last columns.
Reach fit_reach(const Eigen::MatrixXd& places, Eigen::Index held);

/// The weights of the rows of `places` at given parameters, in the order of the rows.
Eigen::VectorXd weights(const Reach& reach, const Eigen::RowVectorXd& parameters);

/// The range of a parameter attainable by blends.
struct ParameterRange {
  double least = 0.0;
  double most = 0.0;
  double miss = 0.0;  ///< Euclidean deviation of the other parameters from the request
};

/// Feasible range of parameter `which` over all weights ≥ 0 with Σ = 1 that give the other
/// parameters the values in `request` or, if the examples do not allow that, the nearest possible
/// ones. `places` has one row per example. Exact to 1e-6.
ParameterRange feasible_range(const Eigen::MatrixXd& places, const Eigen::RowVectorXd& request,
                              Eigen::Index which);

/// Effective number of examples of a blend: 1 / Σ w².
double effective_examples(const Eigen::VectorXd& weights);

}  // namespace mien::motion
