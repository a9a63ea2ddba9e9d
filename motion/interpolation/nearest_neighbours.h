#pragma once

#include <functional>

#include <Eigen/Core>

#include "motion/interpolation/interpolation_options.h"

namespace mien::motion {

/// Measures the parameters of the blend with these weights (≥ 0, sum 1).
using MeasureBlend = std::function<Eigen::RowVectorXd(const Eigen::VectorXd& weights)>;

/// Samples of parameter space: the examples and random blends of them (Kovar and Gleicher 2004).
/// Each sample is a set of weights, and the parameters that these really have.
struct NearestNeighbours {
  Eigen::MatrixXd parameters;  ///< one row a sample (S × M); the first N rows are the examples
  Eigen::MatrixXd weights;     ///< one row a sample (S × N)
  int neighbours = 1;
};

/// `places`: parameters of examples, all different (N × M). Random blends are made of M + 1
/// examples each and kept when their parameters, as `measure` finds them (mean of the examples' by
/// weight when empty), are farther than `least_distance` from all samples so far. What is drawn
/// depends on the seed and on where the examples stand, not on their order.
NearestNeighbours fit_nearest_neighbours(const Eigen::MatrixXd& places,
                                         const NearestNeighboursOptions& options = {},
                                         const MeasureBlend& measure = {});

/// Weights of the N examples: of the k nearest samples by 1/d_i − 1/d_k, which fades a neighbour
/// out before another takes its place. A sample nearer than 1e-9 has all the weight. With two
/// samples both count, by 1/d. ≥ 0, sum 1.
Eigen::VectorXd weights(const NearestNeighbours& samples, const Eigen::RowVectorXd& parameters);

/// Shepard's weights, w_i ∝ d_i^−power, over all places. ≥ 0, sum 1; all at a place nearer than
/// 1e-9.
Eigen::VectorXd inverse_distance_weights(const Eigen::MatrixXd& places,
                                         const Eigen::RowVectorXd& parameters, double power = 2.0);

}  // namespace mien::motion
