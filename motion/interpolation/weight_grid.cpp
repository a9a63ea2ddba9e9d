#include "motion/interpolation/weight_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "motion/error.h"

namespace mien::motion {

WeightGrid make_weight_grid(const Eigen::MatrixXd& places, int cells) {
  assert(places.rows() > 0 && cells > 0);
  if (places.cols() > max_grid_dimensions) {
    throw Error("a grid over " + std::to_string(places.cols()) + " parameters has too many corners",
                "name at most " + std::to_string(max_grid_dimensions) +
                    " parameters, or use another interpolation method");
  }
  WeightGrid grid;
  grid.first = places.colwise().minCoeff().cwiseMin(0.0);
  grid.last = places.colwise().maxCoeff().cwiseMax(1.0);
  grid.cells = cells;
  return grid;
}

Eigen::VectorXd weights(const WeightGrid& grid, const WeightsAt& at_node,
                        const Eigen::RowVectorXd& parameters) {
  const auto dimensions = static_cast<int>(grid.first.size());
  assert(parameters.size() == dimensions);
  const Eigen::RowVectorXd spacing = (grid.last - grid.first) / grid.cells;
  const Eigen::RowVectorXd inside = parameters.cwiseMax(grid.first).cwiseMin(grid.last);
  Eigen::RowVectorXd corner(dimensions);
  Eigen::RowVectorXd share(dimensions);
  for (int m = 0; m < dimensions; ++m) {
    const double steps = (inside[m] - grid.first[m]) / spacing[m];
    corner[m] = std::clamp(std::floor(steps), 0.0, grid.cells - 1.0);
    share[m] = steps - corner[m];
  }
  Eigen::VectorXd sum;
  for (unsigned bits = 0; bits < (1u << dimensions); ++bits) {
    double weight = 1.0;
    Eigen::RowVectorXd node(dimensions);
    for (int m = 0; m < dimensions; ++m) {
      const bool upper = (bits >> m) & 1u;
      weight *= upper ? share[m] : 1.0 - share[m];
      node[m] = grid.first[m] + (corner[m] + (upper ? 1.0 : 0.0)) * spacing[m];
    }
    if (weight == 0.0) continue;
    const Eigen::VectorXd there = at_node(node);
    if (sum.size() == 0) sum = Eigen::VectorXd::Zero(there.size());
    sum += weight * there;
  }
  return sum;
}

}  // namespace mien::motion
