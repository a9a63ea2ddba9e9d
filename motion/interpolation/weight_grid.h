#pragma once

#include <functional>

#include <Eigen/Core>

#include "motion/interpolation/interpolation_options.h"

namespace mien::motion {

/// Function that computes weights at given parameters by another method; it is sampled at the nodes
/// of the grid.
using WeightsAt = std::function<Eigen::VectorXd(const Eigen::RowVectorXd& parameters)>;

/// A regular grid over parameter space, with multilinear interpolation between its nodes (Wiley and
/// Hahn 1997). It spans [0, 1] and all examples in every dimension.
struct WeightGrid {
  Eigen::RowVectorXd first;  ///< lowest node of each dimension
  Eigen::RowVectorXd last;   ///< highest node of each dimension
  int cells = 8;             ///< per dimension
};

/// A grid that spans the examples (one row of `places` each). Throws Error if there are more than
/// `max_grid_dimensions` parameters, because a cell has 2^M corners.
WeightGrid make_weight_grid(const Eigen::MatrixXd& places, int cells);

/// Weights at given parameters by multilinear interpolation between the corners of the grid cell.
/// Parameters outside the grid are clamped to its border. Equal to `at_node` at the nodes; they sum
/// to 1 if those of `at_node` do.
Eigen::VectorXd weights(const WeightGrid& grid, const WeightsAt& at_node,
                        const Eigen::RowVectorXd& parameters);

}  // namespace mien::motion
