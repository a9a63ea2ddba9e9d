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
  /// Sentences about the fit for the user: examples with equal parameters, collinear parameters, a
  /// system that had to be regularised.
  std::vector<std::string> remarks;
};

/// The blend weights of the examples at given parameters.
struct InterpolatedWeights {
  Eigen::VectorXd weights;                 ///< one an example, ≥ 0, sum 1; for `pca` of any sign
  std::optional<double> expected_error_m;  ///< kriging: expected RMS distance of joints, metres
  std::vector<std::string> remarks;        ///< sentences about this query
};

/// Fits a method. `parameters`: one row for each example of the set (N × M; N × N and ignored for
/// `direct`). `names`: of the parameters, for remarks; numbers if empty. The last `held` parameters
/// are not requested but held as nearly as possible: for `reach` they have lower priority, the
/// other methods treat them like the rest. Throws Error when the method does not support that many
/// parameters.
Interpolator fit_interpolator(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                              const InterpolationOptions& options,
                              const std::vector<std::string>& names = {}, Eigen::Index held = 0);

InterpolatedWeights weights_at(const Interpolator& interpolator,
                               const Eigen::RowVectorXd& parameters);

/// The motion at given parameters: a blend by `weights_at`, or the motion of the statistical model.
Example motion_at(const Interpolator& interpolator, const ExampleSet& set,
                  const Eigen::RowVectorXd& parameters, const BlendOptions& options = {});

/// Shares divided by their sum; equal when all are zero. Shares are ≥ 0.
Eigen::VectorXd direct_weights(const Eigen::VectorXd& shares);

/// Half the mean squared distance, m², of the 20 joints over the 11 corresponding times of D, for
/// every pair of examples (N × N): the dissimilarity of motions for kriging.
Eigen::MatrixXd half_squared_differences(const ExampleSet& set);

}  // namespace mien::motion
