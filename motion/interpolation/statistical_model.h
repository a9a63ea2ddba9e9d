#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/blend.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// A motion as one long vector, registered in time: at each of `samples` corresponding moments the
/// direction vectors of all joints and the root, and once the logarithms of the keytime intervals
/// and the displacement of a cycle.
///
/// Principal components of the examples' vectors and their regression on parameters (after Min,
/// Chen and Chai 2009): x = mean + components · c, and the coordinates at parameters are either
/// expected, E[c|p] = Σ_cp (Σ_pp + ridge)⁻¹ (p − p̄), or most likely: those that minimise
/// ‖C c − (p − p̄)‖²/noise² + cᵀ Λ⁻¹ c, where C, the regression of parameters on coordinates,
/// measures a motion and Λ holds the components' variances. Both are linear in p. Unlike the other
/// methods it does not reproduce its examples: variation that only few of them share is lost.
struct StatisticalModel {
  Skeleton body;
  bool loops = false;
  int samples = 0;
  std::vector<double> keytimes;  ///< of the mean motion: the time in which all are registered
  WarpShape warp = WarpShape::monotone;
  Eigen::VectorXd mean;                 ///< D
  Eigen::MatrixXd components;           ///< D × q, orthonormal
  Eigen::VectorXd variances;            ///< q, descending
  double kept_variance = 1.0;           ///< share of the examples' variance
  Eigen::RowVectorXd parameter_mean;    ///< M
  Eigen::MatrixXd regression;           ///< q × M: of either estimate
  Eigen::MatrixXd example_coordinates;  ///< q × N: c of the examples
};

/// `parameters`: one row an example (N × M). The set's examples stand on one body and have the same
/// number of keytimes.
StatisticalModel fit_statistical_model(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                                       const StatisticalModelOptions& options = {},
                                       WarpShape warp = WarpShape::monotone);

/// Coordinates at given parameters, expected or most likely.
Eigen::VectorXd coordinates_at(const StatisticalModel& model, const Eigen::RowVectorXd& parameters);

/// The motion with these coordinates. A loop's duration is rounded to whole frames.
Example motion_of(const StatisticalModel& model, const Eigen::VectorXd& coordinates,
                  double frames_per_second);

/// Weights of the examples (sum 1, may be negative) whose sum of vectors is the motion at
/// the parameters: what this method amounts to as a blend.
Eigen::VectorXd equivalent_weights(const StatisticalModel& model,
                                   const Eigen::RowVectorXd& parameters);

}  // namespace mien::motion
