#pragma once

#include <optional>

#include <Eigen/Core>

#include "motion/interpolation/interpolation_options.h"
#include "motion/math/linear_system.h"

namespace mien::motion {

/// Expected dissimilarity (half the mean squared difference) of two motions as a function of their
/// distance in parameter space: γ(h) = sill · (1 − exp(−(h/range)²)).
struct Variogram {
  double sill = 1.0;   ///< in the unit of the dissimilarity, e.g. m²
  double range = 1.0;  ///< in units of the parameters, > 0

  double operator()(double distance) const;
};

/// Universal kriging of weights (Mukai and Kuriyama 2005): the weights with the smallest expected
/// squared error among those that reproduce all linear functions of the parameters.
struct Kriging {
  Eigen::MatrixXd places;      ///< distinct parameters of the examples, K × M
  Eigen::RowVectorXd mean;     ///< mean of `places`
  Eigen::MatrixXd drift_axes;  ///< M × r: axes along which `places` vary; ordinary: r = 0
  Variogram variogram;
  bool fitted = false;  ///< whether the variogram was fitted to dissimilarities of motions; if not,
                        ///< its sill is 1 and its range follows from the median distance
  int halvings = 0;     ///< number of times the range was halved to keep the system solvable
  LinearSystem system;  ///< [Γ F; Fᵀ 0], Γ in units of the sill
};

/// Weights of the K rows of `places`, and the expected squared error of the blend in the unit of
/// the dissimilarity (0 at a row of `places` if the nugget is 0).
struct KrigedWeights {
  Eigen::VectorXd weights;
  double variance = 0.0;
};

/// Fits universal kriging. `places` holds the parameters of the examples, one row each, all
/// different. `half_squared_differences` (K × K) holds the dissimilarities ½‖m_i − m_k‖² of the
/// motions, to which the variogram is fitted by least squares over all pairs. Without it, or with
/// fewer than three rows, the range is derived from the median distance of the rows, and the
/// variance is only relative. If rows are collinear, or there are more parameters than rows, the
/// drift is restricted to the directions in which the rows vary.
Kriging fit_kriging(const Eigen::MatrixXd& places, const KrigingOptions& options = {},
                    const std::optional<Eigen::MatrixXd>& half_squared_differences = {});

/// Kriging weights at given parameters, before clipping: they sum to 1 but may lie outside [0, 1].
KrigedWeights kriged_weights(const Kriging& kriging, const Eigen::RowVectorXd& parameters);

}  // namespace mien::motion
