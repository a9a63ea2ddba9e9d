#include <random>

#include <gtest/gtest.h>

#include "motion/math/convex_weights.h"

namespace mien::motion {
namespace {

Eigen::MatrixXd random_matrix(std::mt19937& random, Eigen::Index rows, Eigen::Index columns) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

TEST(NonnegativeLeastSquares, IsThePlainSolutionWhereThatIsNotNegative) {
  Eigen::MatrixXd a(3, 2);
  a << 1, 0, 0, 2, 0, 0;
  const Eigen::VectorXd x = nonnegative_least_squares(a, Eigen::Vector3d(3, 4, 5));
  EXPECT_NEAR(x[0], 3.0, 1e-12);
  EXPECT_NEAR(x[1], 2.0, 1e-12);
}

// |(x1 + x2 − 1, x2 + 1)| over x ≥ 0: x2 would be −1 and is 0, so x1 is 1.
TEST(NonnegativeLeastSquares, BindsWhatWouldBeNegative) {
  Eigen::MatrixXd a(2, 2);
  a << 1, 1, 0, 1;
  const Eigen::VectorXd x = nonnegative_least_squares(a, Eigen::Vector2d(1, -1));
  EXPECT_NEAR(x[0], 1.0, 1e-12);
  EXPECT_EQ(x[1], 0.0);
}

// Karush, Kuhn and Tucker's conditions hold at the least of a convex problem and nowhere else.
TEST(NonnegativeLeastSquares, MeetsTheConditionsOfALeast) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Index rows = 1 + trial % 12;
    const Eigen::Index columns = 1 + trial % 17;
    Eigen::MatrixXd a = random_matrix(random, rows, columns);
    if (trial % 3 == 0 && columns > 1) a.col(1) = a.col(0);  // columns that say the same
    const Eigen::VectorXd b = random_matrix(random, rows, 1);
    const Eigen::VectorXd x = nonnegative_least_squares(a, b);
    const Eigen::VectorXd descent = a.transpose() * (b - a * x);
    for (Eigen::Index i = 0; i < columns; ++i) {
      ASSERT_GE(x[i], 0.0) << trial;
      ASSERT_LE(descent[i], 1e-8) << trial;
      ASSERT_NEAR(x[i] * descent[i], 0.0, 1e-8) << trial;
    }
  }
}

}  // namespace
}  // namespace mien::motion
