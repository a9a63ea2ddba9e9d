#pragma once

#include <functional>

#include <Eigen/Core>

#include "motion/interpolation/interpolation_options.h"

namespace mien::motion {

/// Weights at parameters by another method, which the grid samples.
using WeightsAt = std::function<Eigen::VectorXd(const Eigen::RowVectorXd& parameters)>;

/// A regular grid over parameter space, with multilinear interpolation between its nodes (Wiley and
/// Hahn 1997). It spans [0, 1] and all examples in every dimension.
struct WeightGrid {
  Eigen::RowVectorXd first;  ///< lowest node of each dimension
  Eigen::RowVectorXd last;   ///< highest node of each dimension
  int cells = 8;             ///< a dimension
};

/// Throws Error when there are more than `max_grid_dimensions` parameters: a cell has 2^M corners.
WeightGrid make_weight_grid(const Eigen::MatrixXd& places, int cells);

/// Multilinear between the corners of the cell in which the parameters lie. Outside the grid: the
/// nearest place on its border. Sums to 1 when `at_node` does; equal to it at the nodes.
Eigen::VectorXd weights(const WeightGrid& grid, const WeightsAt& at_node,
                        const Eigen::RowVectorXd& parameters);

}  // namespace mien::motion
