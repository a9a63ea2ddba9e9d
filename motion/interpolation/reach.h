#pragma once

#include <Eigen/Core>

#include "motion/interpolation/cardinal_basis.h"

namespace mien::motion {

/// Weights that meet the requested parameters exactly where possible: of all weights w ≥ 0, Σ w =
/// 1, whose weighted parameters are the requested ones, those nearest to the cardinal basis'
/// weights; if there are none, those with the smallest deviation. Related to inverse blending
/// (Huang & Kallmann 2010), which adjusts weights until a constraint on the pose holds. The weights
/// follow the parameters continuously.
///
/// Parameters may also be held: then, among weights that meet the requested ones, those with the
/// smallest deviation of the held ones are preferred.
struct Reach {
  CardinalBasis basis;        ///< of the requested parameters alone
  Eigen::MatrixXd asked;      ///< one column for each place, one row for each requested parameter
  Eigen::MatrixXd held_rows;  ///< the same of the held ones
};

/// Fits the method. `places`: one row for each place, the requested parameters first, then `held`
/// held ones.
Reach fit_reach(const Eigen::MatrixXd& places, Eigen::Index held);

/// The weights of the places at `parameters`, in the order of the columns of `places`.
Eigen::VectorXd weights(const Reach& reach, const Eigen::RowVectorXd& parameters);

/// The range of a parameter that blends can have.
struct ParameterRange {
  double least = 0.0;
  double most = 0.0;
  double miss = 0.0;  ///< Euclidean deviation of the other parameters from the request
};

/// Feasible range of parameter `which`, over weights ≥ 0, Σ = 1, whose other parameters are those
/// of `request` or, if the examples do not allow that, as near as possible. `places`: one row for
/// each place; exact to 1e-6. Solved by linear programming.
ParameterRange feasible_range(const Eigen::MatrixXd& places, const Eigen::RowVectorXd& request,
                              Eigen::Index which);

/// Effective number of examples of a blend: 1 / Σ w².
double effective_examples(const Eigen::VectorXd& weights);

}  // namespace mien::motion
