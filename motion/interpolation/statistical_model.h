#pragma once

#include <vector>

#include <Eigen/Core>

#include "motion/interpolation/blend.h"
#include "motion/interpolation/interpolation_options.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// A statistical model of motions. Each motion is represented as one long vector, registered in
/// time: the direction vectors of all joints and the root position at each of `samples`
/// corresponding moments, followed by the logarithms of the keytime intervals and the displacement
/// per cycle.
///
/// The model consists of the principal components of the examples' vectors and the regression
/// between coordinates and parameters (after Min, Chen and Chai 2009): x = mean + components · c.
/// The coordinates at given parameters are either expected, E[c|p] = Σ_cp (Σ_pp + ridge)⁻¹ (p −
/// p̄), or most likely, minimising ‖C c − (p − p̄)‖²/noise² + cᵀ Λ⁻¹ c. Here C is the regression of
/// parameters on coordinates, which predicts the parameters of a motion, and Λ holds the variances
/// of the components. Both estimates are linear in p. The model does not reproduce its examples
/// exactly: variation that only few of them share is lost. Sizes below: D numbers
/// per vector, q components, M parameters, N examples.
struct StatisticalModel {
  Skeleton body;
  bool loops = false;
  int samples = 0;
  std::vector<double> keytimes;  ///< of the mean motion, seconds: the common time base
  WarpShape warp = WarpShape::monotone;
  Eigen::VectorXd mean;               ///< D
  Eigen::MatrixXd components;         ///< D × q, orthonormal
  Eigen::VectorXd variances;          ///< q, descending
  double kept_variance = 1.0;         ///< retained fraction of the examples' variance
  Eigen::RowVectorXd parameter_mean;  ///< M
  Eigen::MatrixXd regression;  ///< q × M: from parameters to coordinates, by the chosen estimate
  Eigen::MatrixXd example_coordinates;  ///< q × N: coordinates c of the examples
};

/// Fits the model. `parameters` has one row per example (N × M). All examples have the same body
/// and the same number of keytimes.
StatisticalModel fit_statistical_model(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                                       const StatisticalModelOptions& options = {},
                                       WarpShape warp = WarpShape::monotone);

/// Coordinates at given parameters, expected or most likely.
Eigen::VectorXd coordinates_at(const StatisticalModel& model, const Eigen::RowVectorXd& parameters);

/// The motion with given coordinates. The duration is rounded to whole frames, and the keytimes are
/// scaled accordingly.
Example motion_of(const StatisticalModel& model, const Eigen::VectorXd& coordinates,
                  double frames_per_second);

/// The equivalent blend weights of the examples (sum 1, possibly negative): the weighted sum of
/// their vectors is the motion at the given parameters.
Eigen::VectorXd equivalent_weights(const StatisticalModel& model,
                                   const Eigen::RowVectorXd& parameters);

}  // namespace mien::motion
