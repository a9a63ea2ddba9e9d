#pragma once

#include <Eigen/Core>

#include "motion/interpolation/cardinal_basis.h"

namespace mien::motion {

/// Weights that meet what is asked, and not only come near it: of all weights w ≥ 0, Σ w = 1, whose
/// weighted parameters are the asked ones, those nearest to the cardinal basis' weights; where none
/// are, those that miss them least. Kin of inverse blending (Huang & Kallmann 2010), which moves
/// weights until a constraint on the pose holds. The weights follow the parameters continuously.
///
/// Parameters may also be held: then, among weights that meet the asked ones, those come first that
/// miss the held ones least.
struct Reach {
  CardinalBasis basis;        ///< of the asked parameters alone
  Eigen::MatrixXd asked;      ///< one column a place, one row an asked parameter
  Eigen::MatrixXd held_rows;  ///< the same of the held ones
};

/// `places`: one row a place, the asked parameters first, then `held` held ones.
Reach fit_reach(const Eigen::MatrixXd& places, Eigen::Index held);

/// Weights of places. `parameters`: as the columns of `places`.
Eigen::VectorXd weights(const Reach& reach, const Eigen::RowVectorXd& parameters);

/// The least and the most that a blend can have of a parameter.
struct ParameterRange {
  double least = 0.0;
  double most = 0.0;
  double miss = 0.0;  ///< how far from the wish the other parameters stay, Euclidean
};

/// Of parameter `which`, for weights ≥ 0, Σ = 1, that have the other parameters at `wish`, or,
/// where the examples do not allow that, as near to it as they can be. `places`: one row a place;
/// right to 1e-6. A linear programme.
ParameterRange feasible_range(const Eigen::MatrixXd& places, const Eigen::RowVectorXd& wish,
                              Eigen::Index which);

/// 1 / Σ w²: as many examples of equal weight would be as mixed.
double effective_examples(const Eigen::VectorXd& weights);

}  // namespace mien::motion
