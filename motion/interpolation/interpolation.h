#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/blend.h"
#include "motion/interpolation/cardinal_basis.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/interpolation/kriging.h"
#include "motion/interpolation/nearest_neighbours.h"
#include "motion/interpolation/parameter_table.h"
#include "motion/interpolation/reach.h"
#include "motion/interpolation/statistical_model.h"
#include "motion/interpolation/weight_grid.h"
#include "motion/interpolation/word_clicks.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

struct InverseDistance {
  double power = 2.0;  ///< exponent of the inverse distances, > 0
};

struct GridOfWeights {
  WeightGrid grid;
  std::variant<CardinalBasis, NearestNeighbours> source;
};

struct DirectShares {};

/// A method fitted to a set of examples and their parameters.
struct Interpolator {
  DistinctParameters distinct;
  std::vector<std::string> names;  ///< names of the parameters
  std::variant<CardinalBasis, Reach, NearestNeighbours, InverseDistance, GridOfWeights, Kriging,
               StatisticalModel, WordClicks, DirectShares>
      method;
  /// Sentences about the fit for the user, for example about examples with equal parameters,
  /// collinear parameters, or a system that had to be regularised.
  std::vector<std::string> remarks;
};

/// The blend weights of the examples at given parameters.
struct InterpolatedWeights {
  Eigen::VectorXd weights;  ///< one per example, ≥ 0, sum 1; for `pca` also negative
  std::optional<double> expected_error_m;  ///< kriging of at least three distinct positions:
                                           ///< expected RMS joint distance, metres
  std::vector<std::string> remarks;        ///< sentences about this query
};

/// Fits a method to a set of examples. `parameters` has one row per example (N × M; for `direct` N
/// × N and ignored). `names` are the parameter names used in remarks; if empty, numbers are used.
/// The last `held` parameters are not requested but kept as close as possible to given values:
/// `reach` gives them lower priority, whereas the other methods treat them like the rest. Throws
/// Error if the method does not support so many parameters.
Interpolator fit_interpolator(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                              const InterpolationOptions& options,
                              const std::vector<std::string>& names = {}, Eigen::Index held = 0);

InterpolatedWeights weights_at(const Interpolator& interpolator,
                               const Eigen::RowVectorXd& parameters);

/// The motion at given parameters: a blend with `weights_at`, or the motion of the statistical
/// model.
Example motion_at(const Interpolator& interpolator, const ExampleSet& set,
                  const Eigen::RowVectorXd& parameters, const BlendOptions& options = {});

/// Shares divided by their sum; equal weights if all are zero. Shares must be ≥ 0.
Eigen::VectorXd direct_weights(const Eigen::VectorXd& shares);

/// The dissimilarity of motions for kriging, for every pair of examples (N × N): half the mean
/// squared distance, m², over the 20 joints and 11 corresponding times of D.
Eigen::MatrixXd half_squared_differences(const ExampleSet& set);

}  // namespace mien::motion
