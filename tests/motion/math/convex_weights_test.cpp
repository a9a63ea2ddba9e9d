#include "motion/math/convex_weights.h"

#include <random>

#include <Eigen/QR>
#include <gtest/gtest.h>

namespace mien::motion {
namespace {

Eigen::MatrixXd random_points(std::mt19937& random, Eigen::Index rows, Eigen::Index columns) {
  std::uniform_real_distribution<double> uniform;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

/// ≥ 0, of sum 1, few of them 0.
Eigen::VectorXd random_weights(std::mt19937& random, Eigen::Index count) {
  const Eigen::VectorXd shares = random_points(random, count, 1).array().pow(3);
  return shares / shares.sum();
}

/// Points as studies have them, and as they make trouble: some at one place, all on a line, on a
/// grid.
Eigen::MatrixXd points_of_kind(std::mt19937& random, int kind, Eigen::Index rows,
                               Eigen::Index columns) {
  Eigen::MatrixXd points = random_points(random, rows, columns);
  if (kind == 1) points.rightCols(columns / 2) = points.leftCols(columns / 2);
  if (kind == 2) points = points.col(0) * random_points(random, 1, columns);
  if (kind == 3) points = (points * 3.0).array().round() / 3.0;
  return points;
}

/// The least |C w − d|² at that mean, by trying every set of weights that may be above 0.
double least_by_enumeration(const Eigen::MatrixXd& points, const Eigen::VectorXd& mean,
                            const Eigen::MatrixXd& c, const Eigen::VectorXd& d) {
  const auto count = static_cast<int>(points.cols());
  double least = std::numeric_limits<double>::infinity();
  for (int set = 1; set < 1 << count; ++set) {
    std::vector<Eigen::Index> free;
    for (int i = 0; i < count; ++i)
      if ((set >> i & 1) != 0) free.push_back(i);
    const auto n = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd fixed(points.rows() + 1, n);
    fixed << Eigen::RowVectorXd::Ones(n), points(Eigen::all, free);
    Eigen::VectorXd right(fixed.rows());
    right << 1.0, mean;
    const Eigen::MatrixXd columns = c(Eigen::all, free);
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + fixed.rows(), n + fixed.rows());
    system.topLeftCorner(n, n) = columns.transpose() * columns;
    system.topRightCorner(n, fixed.rows()) = fixed.transpose();
    system.bottomLeftCorner(fixed.rows(), n) = fixed;
    Eigen::VectorXd sides(system.rows());
    sides << columns.transpose() * d, right;
    const Eigen::VectorXd w = system.completeOrthogonalDecomposition().solve(sides).head(n);
    if (w.minCoeff() < -1e-9 || (fixed * w - right).norm() > 1e-8) continue;
    least = std::min(least, (columns * w - d).squaredNorm());
  }
  return least;
}

TEST(ConvexWeights, HaveTheMeanThatIsAskedForWithinTheHull) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 400; ++trial) {
    const Eigen::Index count = 2 + trial % 29;
    const Eigen::MatrixXd points = points_of_kind(random, trial % 4, 1 + trial % 5, count);
    const Eigen::VectorXd mean = points * random_weights(random, count);
    const Eigen::VectorXd weights = weights_nearest_to(points, mean);
    ASSERT_GE(weights.minCoeff(), 0.0);
    ASSERT_NEAR(weights.sum(), 1.0, 1e-12);
    ASSERT_NEAR((points * weights - mean).norm(), 0.0, 1e-9) << trial;
    ASSERT_LE((weights.array() > 0.0).count(), points.rows() + 1);
  }
}

// The nearest point of a convex set is the one from which no point lies towards the target.
TEST(ConvexWeights, HaveTheNearestMeanOutsideTheHull) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 400; ++trial) {
    const Eigen::MatrixXd points = points_of_kind(random, trial % 4, 1 + trial % 5, 2 + trial % 29);
    const Eigen::VectorXd target =
        4.0 * random_points(random, points.rows(), 1) - Eigen::VectorXd::Ones(points.rows());
    const Eigen::VectorXd mean = points * weights_nearest_to(points, target);
    const Eigen::VectorXd towards = target - mean;
    ASSERT_LE(((points.colwise() - mean).transpose() * towards).maxCoeff(), 1e-9) << trial;
  }
}

TEST(ConvexWeights, LeaveTheLeastSquaresThatTheirMeanAllows) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Index count = 2 + trial % 6;
    const Eigen::MatrixXd points = points_of_kind(random, trial % 4, 1 + trial % 3, count);
    // Within the hull, on its border, at one of the points.
    Eigen::VectorXd mixed = random_weights(random, count);
    if (trial % 5 == 1)
      mixed = weights_nearest_to(points, Eigen::VectorXd::Constant(points.rows(), 3.0));
    if (trial % 5 == 2) mixed = Eigen::VectorXd::Unit(count, trial % count);
    const Eigen::VectorXd start = weights_nearest_to(points, points * mixed);
    const Eigen::VectorXd mean = points * start;
    Eigen::MatrixXd c(2 + count, count);
    c << 5.0 * random_points(random, 2, count), Eigen::MatrixXd::Identity(count, count);
    const Eigen::VectorXd d = random_points(random, 2 + count, 1);
    const Eigen::VectorXd weights = least_squares_at_mean(points, start, c, d);
    ASSERT_GE(weights.minCoeff(), -1e-12) << trial;
    ASSERT_NEAR(weights.sum(), 1.0, 1e-12) << trial;
    ASSERT_NEAR((points * weights - mean).norm(), 0.0, 1e-9) << trial;
    ASSERT_NEAR((c * weights - d).squaredNorm(), least_by_enumeration(points, mean, c, d), 1e-8)
        << trial;
  }
}

}  // namespace
}  // namespace mien::motion
