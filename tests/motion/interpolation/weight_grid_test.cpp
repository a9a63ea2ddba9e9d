#include "motion/interpolation/weight_grid.h"

#include <gtest/gtest.h>

#include "motion/interpolation/cardinal_basis.h"

namespace mien::motion {
namespace {

const Eigen::MatrixXd corners_and_middle =
    (Eigen::MatrixXd(5, 2) << 0, 0, 1, 0, 0, 1, 1, 1, .5, .2).finished();

TEST(WeightGrid, SpansZeroToOneAndAllExamples) {
  Eigen::MatrixXd wide = corners_and_middle;
  wide(1, 0) = 1.5;
  wide(2, 1) = -0.5;
  const WeightGrid grid = make_weight_grid(wide, 4);
  EXPECT_EQ(grid.first, Eigen::RowVector2d(0.0, -0.5));
  EXPECT_EQ(grid.last, Eigen::RowVector2d(1.5, 1.0));
}

TEST(WeightGrid, IsTheMethodItselfAtItsNodes) {
  const CardinalBasis basis = fit_cardinal_basis(corners_and_middle);
  const auto at_node = [&](const Eigen::RowVectorXd& p) { return weights(basis, p); };
  const WeightGrid grid = make_weight_grid(corners_and_middle, 5);
  for (int i = 0; i <= 5; ++i) {
    for (int k = 0; k <= 5; ++k) {
      const Eigen::RowVector2d node(i / 5.0, k / 5.0);
      EXPECT_LT((weights(grid, at_node, node) - at_node(node)).norm(), 1e-12);
    }
  }
}

TEST(WeightGrid, IsBilinearInACell) {
  const auto product = [](const Eigen::RowVectorXd& p) {
    return Eigen::VectorXd(Eigen::Vector2d(p[0] * p[1], 1.0 - p[0] * p[1]));
  };
  const WeightGrid grid = make_weight_grid(corners_and_middle, 3);
  const Eigen::RowVector2d at(0.41, 0.77);
  EXPECT_LT((weights(grid, product, at) - product(at)).norm(), 1e-14);
}

TEST(WeightGrid, ComesNearerToTheMethodWithMoreCells) {
  const CardinalBasis basis = fit_cardinal_basis(corners_and_middle);
  const auto at_node = [&](const Eigen::RowVectorXd& p) { return weights(basis, p); };
  const auto worst = [&](int cells) {
    const WeightGrid grid = make_weight_grid(corners_and_middle, cells);
    double largest = 0.0;
    for (int i = 0; i < 441; ++i) {
      const Eigen::RowVector2d at(0.05 * (i % 21), 0.05 * (i / 21));
      largest = std::max(largest, (weights(grid, at_node, at) - at_node(at)).norm());
    }
    return largest;
  };
  EXPECT_LT(worst(32), 0.3 * worst(8));
}

TEST(WeightGrid, StaysAtItsBorderOutside) {
  const CardinalBasis basis = fit_cardinal_basis(corners_and_middle);
  const auto at_node = [&](const Eigen::RowVectorXd& p) { return weights(basis, p); };
  const WeightGrid grid = make_weight_grid(corners_and_middle, 4);
  EXPECT_EQ(weights(grid, at_node, Eigen::RowVector2d(7.0, 0.3)),
            weights(grid, at_node, Eigen::RowVector2d(1.0, 0.3)));
}

}  // namespace
}  // namespace mien::motion
