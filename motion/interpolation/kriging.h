#pragma once

#include <optional>

#include <Eigen/Core>

#include "motion/interpolation/interpolation_options.h"
#include "motion/math/linear_system.h"

namespace mien::motion {

/// Expected dissimilarity of two motions by their distance in parameter space: half the mean
/// squared difference, γ(h) = sill · (1 − exp(−(h/range)²)).
struct Variogram {
  double sill = 1.0;   ///< in the unit of the dissimilarity, e.g. m²
  double range = 1.0;  ///< in units of the parameters, > 0

  double operator()(double distance) const;
};

/// Universal kriging of weights (Mukai and Kuriyama 2005): the weights with the least expected
/// error that reproduce all linear functions of the parameters.
struct Kriging {
  Eigen::MatrixXd places;      ///< K × M
  Eigen::RowVectorXd mean;     ///< of the places
  Eigen::MatrixXd drift_axes;  ///< M × r: directions in which the places spread
  Variogram variogram;
  bool fitted = false;  ///< to dissimilarities of motions; otherwise sill 1 and median distance
  int halvings = 0;     ///< how often the range was halved to stay solvable
  LinearSystem system;  ///< [Γ F; Fᵀ 0], Γ in units of the sill
};

/// Weights of the K places, and the expected squared error of the blend in the unit of the
/// dissimilarity (0 at a place when the nugget is 0).
struct KrigedWeights {
  Eigen::VectorXd weights;
  double variance = 0.0;
};

/// `half_squared_differences` (K × K) holds ½‖m_i − m_k‖² of the motions, to which the variogram is
/// fitted by least squares over all pairs; without it weights are the same up to the range, and the
/// variance is relative. Places are all different. Collinear places and more parameters than places
/// are covered by a drift along the directions in which places spread.
Kriging fit_kriging(const Eigen::MatrixXd& places, const KrigingOptions& options = {},
                    const std::optional<Eigen::MatrixXd>& half_squared_differences = {});

/// Raw weights: sum to 1, may lie outside [0, 1].
KrigedWeights kriged_weights(const Kriging& kriging, const Eigen::RowVectorXd& parameters);

}  // namespace mien::motion
