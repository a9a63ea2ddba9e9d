#pragma once

#include <functional>

#include <Eigen/Core>

#include "motion/interpolation/interpolation_options.h"

namespace mien::motion {

/// Function that measures the parameters of the blend with given weights (≥ 0, sum 1).
using MeasureBlend = std::function<Eigen::RowVectorXd(const Eigen::VectorXd& weights)>;

/// Samples of parameter space: the examples and random blends of them (Kovar and Gleicher 2004).
/// Each sample consists of weights and the measured parameters of the blend with these weights.
struct NearestNeighbours {
  Eigen::MatrixXd parameters;  ///< one row per sample (S × M); the first N rows are the examples
  Eigen::MatrixXd weights;     ///< one row per sample (S × N)
  int neighbours = 1;          ///< k: number of nearest samples used for a blend
};

/// Samples parameter space. `places` holds the parameters of the examples, all different (N × M).
/// Each random blend combines M + 1 examples (or all if there are fewer) and is kept if its
/// parameters are farther than `least_distance` from all previous samples. Its parameters are
/// determined by `measure` or, if `measure` is empty, are the weighted mean of the examples'
/// parameters. The random draws depend on the seed and on the parameters of the examples, but not
/// on their order.
NearestNeighbours fit_nearest_neighbours(const Eigen::MatrixXd& places,
                                         const NearestNeighboursOptions& options = {},
                                         const MeasureBlend& measure = {});

/// Weights of the N examples (≥ 0, sum 1) at given parameters: a weighted mean of the k nearest
/// samples. Their weights are proportional to 1/d_i − 1/d_k (d_i: distance of the i-th nearest
/// sample from the parameters), which fades out a neighbour before another one replaces it, or to
/// 1/d_i if k is at most 2. A sample closer than 1e-9 gets all the weight.
Eigen::VectorXd weights(const NearestNeighbours& samples, const Eigen::RowVectorXd& parameters);

/// Shepard's inverse distance weights, w_i ∝ d_i^−power, of all rows of `places`; ≥ 0, sum 1. A row
/// closer than 1e-9 gets all the weight.
Eigen::VectorXd inverse_distance_weights(const Eigen::MatrixXd& places,
                                         const Eigen::RowVectorXd& parameters, double power = 2.0);

}  // namespace mien::motion
