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
  double power = 2.0;
};

struct GridOfWeights {
  WeightGrid grid;
  std::variant<CardinalBasis, NearestNeighbours> source;
};

struct DirectShares {};

/// A method, fitted to a set of examples and their parameters.
struct Interpolator {
  DistinctParameters distinct;
  std::vector<std::string> names;  ///< of the parameters
  std::variant<CardinalBasis, Reach, NearestNeighbours, InverseDistance, GridOfWeights, Kriging,
               StatisticalModel, WordClicks, DirectShares>
      method;
  /// Plain sentences on what the user should know of the fit: examples that share a place,
  /// parameters that say the same, a system that had to be made easier.
  std::vector<std::string> remarks;
};

/// The examples' shares at parameters.
struct InterpolatedWeights {
  Eigen::VectorXd weights;  ///< one an example, ≥ 0, sum 1; of `pca` equivalent ones, any sign
  std::optional<double> expected_error_m;  ///< kriging: expected RMS distance of joints, metres
  std::vector<std::string> remarks;        ///< plain sentences on this query
};

/// Fits once. `parameters`: one row an example of the set (N × M; N × N for `direct`, not looked
/// at). `names`: of the parameters, for remarks; numbered without. The last `held` parameters are
/// not asked for but to be kept as near as can be: `reach` lets them wait for the others, to the
/// other methods they are parameters like all. Throws Error when the method cannot take so many
/// parameters.
Interpolator fit_interpolator(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                              const InterpolationOptions& options,
                              const std::vector<std::string>& names = {}, Eigen::Index held = 0);

InterpolatedWeights weights_at(const Interpolator& interpolator,
                               const Eigen::RowVectorXd& parameters);

/// The motion at parameters: a blend by `weights_at`, or what the statistical model expects.
Example motion_at(const Interpolator& interpolator, const ExampleSet& set,
                  const Eigen::RowVectorXd& parameters, const BlendOptions& options = {});

/// Shares divided by their sum; equal when all are zero. Shares are ≥ 0.
Eigen::VectorXd direct_weights(const Eigen::VectorXd& shares);

/// ½ mean squared distance, m², of the 20 joints over the 11 corresponding moments that D looks at,
/// for every pair (N × N): what kriging takes for the unlikeness of motions.
Eigen::MatrixXd half_squared_differences(const ExampleSet& set);

}  // namespace mien::motion
