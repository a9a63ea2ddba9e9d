#include "motion/interpolation/cardinal_basis.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

Eigen::MatrixXd random_examples(std::mt19937_64& random, int count, int parameters) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Eigen::MatrixXd p(count, parameters);
  for (int i = 0; i < count; ++i) {
    for (int m = 0; m < parameters; ++m) p(i, m) = uniform(random);
  }
  return p;
}

Eigen::RowVectorXd random_parameters(std::mt19937_64& random, int parameters, double reach = 1.0) {
  std::uniform_real_distribution<double> uniform(-reach, 1.0 + reach);
  return Eigen::RowVectorXd::NullaryExpr(parameters, [&] { return uniform(random); });
}

TEST(CardinalBasis, BSplineHasItsValuesAtTheKnots) {
  EXPECT_DOUBLE_EQ(cubic_b_spline(0.0), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(cubic_b_spline(1.0), 1.0 / 6.0);
  EXPECT_EQ(cubic_b_spline(2.0), 0.0);
  EXPECT_EQ(cubic_b_spline(7.0), 0.0);
}

// Three examples at 0, ½ and 1: worked by hand.
TEST(CardinalBasis, MatchesTheOneDimensionalCaseWorkedByHand) {
  Eigen::MatrixXd p(3, 1);
  p << 0.0, 0.5, 1.0;
  const CardinalBasis basis = fit_cardinal_basis(p);
  EXPECT_LT((basis.widths - Eigen::Vector3d::Constant(0.5)).norm(), 1e-14);
  // The linear part is stored about the mean 0.5; l_0 and l_1 of the uncentred form follow.
  const Eigen::Vector3d slope = basis.linear.col(1);
  const Eigen::Vector3d constant = basis.linear.col(0) - 0.5 * slope;
  EXPECT_LT((constant - Eigen::Vector3d(5.0 / 6.0, 1.0 / 3.0, -1.0 / 6.0)).norm(), 1e-12);
  EXPECT_LT((slope - Eigen::Vector3d(-1.0, 0.0, 1.0)).norm(), 1e-12);
  EXPECT_LT((basis.radial.col(0) - Eigen::Vector3d(.42857143, -.85714286, .42857143)).norm(), 2e-8);
  EXPECT_LT((basis.radial.col(1) - Eigen::Vector3d(-.71428571, 1.42857143, -.71428571)).norm(),
            2e-8);
  const auto at = [&](double x) { return raw_weights(basis, Eigen::RowVectorXd::Constant(1, x)); };
  EXPECT_LT((at(0.25) - Eigen::Vector3d(.45535714, .58928571, -.04464286)).norm(), 2e-8);
  EXPECT_LT((at(0.1) - Eigen::Vector3d(.80228571, .19542857, .00228571)).norm(), 2e-8);
}

TEST(CardinalBasis, MatchesTheTwoDimensionalCaseWorkedByHand) {
  Eigen::MatrixXd p(5, 2);
  p << 0, 0, 1, 0, 0, 1, 1, 1, .5, .2;
  const CardinalBasis basis = fit_cardinal_basis(p);
  Eigen::VectorXd expected(5);
  expected << .03861848, .04401614, .60677816, .10138050, .20920672;
  EXPECT_LT((raw_weights(basis, Eigen::RowVector2d(.25, .75)) - expected).norm(), 2e-8);
}

TEST(CardinalBasis, IsExactAtTheExamples) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 60; ++trial) {
    const int count = 1 + static_cast<int>(random() % 30);
    const int parameters = 1 + static_cast<int>(random() % 6);
    const Eigen::MatrixXd p = random_examples(random, count, parameters);
    const CardinalBasis basis = fit_cardinal_basis(p);
    for (int k = 0; k < count; ++k) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(count, k);
      EXPECT_LT((raw_weights(basis, p.row(k)) - unit).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_LT((weights(basis, p.row(k)) - unit).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

TEST(CardinalBasis, WeightsSumToOneEverywhere) {
  std::mt19937_64 random(12);
  const Eigen::MatrixXd p = random_examples(random, 14, 4);
  const CardinalBasis basis = fit_cardinal_basis(p);
  for (int i = 0; i < 500; ++i) {
    const Eigen::RowVectorXd at = random_parameters(random, 4, 2.0);
    EXPECT_NEAR(raw_weights(basis, at).sum(), 1.0, 1e-10);
    const Eigen::VectorXd used = weights(basis, at);
    EXPECT_NEAR(used.sum(), 1.0, 1e-12);
    EXPECT_GE(used.minCoeff(), 0.0);
    EXPECT_LE(used.maxCoeff(), 1.0);
  }
}

TEST(CardinalBasis, OrderOfExamplesChangesNothing) {
  std::mt19937_64 random(13);
  const Eigen::MatrixXd p = random_examples(random, 12, 3);
  std::vector<int> order(12);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  Eigen::MatrixXd shuffled(12, 3);
  for (int i = 0; i < 12; ++i) shuffled.row(i) = p.row(order[static_cast<size_t>(i)]);
  const CardinalBasis one = fit_cardinal_basis(p);
  const CardinalBasis other = fit_cardinal_basis(shuffled);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::RowVectorXd at = random_parameters(random, 3);
    const Eigen::VectorXd a = weights(one, at);
    const Eigen::VectorXd b = weights(other, at);
    for (int i = 0; i < 12; ++i) EXPECT_NEAR(b[i], a[order[static_cast<size_t>(i)]], 1e-9);
  }
}

TEST(CardinalBasis, IsContinuous) {
  std::mt19937_64 random(14);
  const CardinalBasis basis = fit_cardinal_basis(random_examples(random, 10, 2));
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::RowVectorXd at = random_parameters(random, 2);
    const Eigen::RowVectorXd step = 1e-7 * Eigen::RowVectorXd::Random(2);
    EXPECT_LT((weights(basis, at + step) - weights(basis, at)).norm(), 1e-4);
  }
}

TEST(CardinalBasis, CollinearExamplesAreStillExact) {
  Eigen::MatrixXd p(6, 3);
  for (int i = 0; i < 6; ++i)
    p.row(i) = Eigen::RowVector3d(0.1, 0.4, 0.2) + i * 0.13 * Eigen::RowVector3d(1, 2, -1);
  const CardinalBasis basis = fit_cardinal_basis(p);
  for (int k = 0; k < 6; ++k) {
    EXPECT_LT((raw_weights(basis, p.row(k)) - Eigen::VectorXd::Unit(6, k)).norm(), 1e-9);
  }
  EXPECT_NEAR(raw_weights(basis, Eigen::RowVector3d(0.9, 0.1, 0.5)).sum(), 1.0, 1e-10);
}

TEST(CardinalBasis, MoreParametersThanExamplesAreStillExact) {
  std::mt19937_64 random(15);
  const Eigen::MatrixXd p = random_examples(random, 4, 9);
  const CardinalBasis basis = fit_cardinal_basis(p);
  for (int k = 0; k < 4; ++k) {
    EXPECT_LT((raw_weights(basis, p.row(k)) - Eigen::VectorXd::Unit(4, k)).norm(), 1e-9);
  }
}

TEST(CardinalBasis, ExamplesAtOnePlaceShareTheirWeight) {
  Eigen::MatrixXd p(4, 2);
  p << 0.2, 0.2, 0.8, 0.3, 0.2, 0.2 + 1e-8, 0.5, 0.9;
  const CardinalBasis basis = fit_cardinal_basis(p);
  const Eigen::VectorXd w = weights(basis, p.row(0));
  EXPECT_NEAR(w[0], 0.5, 1e-9);
  EXPECT_NEAR(w[2], 0.5, 1e-9);
  EXPECT_EQ(basis.distinct.places.rows(), 3);
}

TEST(CardinalBasis, OneExampleHasAllTheWeight) {
  const CardinalBasis basis = fit_cardinal_basis(Eigen::MatrixXd::Constant(1, 3, 0.4));
  EXPECT_DOUBLE_EQ(weights(basis, Eigen::RowVector3d(0.9, 0.0, 0.1))[0], 1.0);
}

TEST(CardinalBasis, FarAwayItIsLinear) {
  std::mt19937_64 random(16);
  const CardinalBasis basis = fit_cardinal_basis(random_examples(random, 9, 2));
  const Eigen::RowVector2d away(40.0, -30.0);
  const Eigen::RowVector2d step(1.0, 0.5);
  const Eigen::VectorXd second = raw_weights(basis, away + step) - 2.0 * raw_weights(basis, away) +
                                 raw_weights(basis, away - step);
  EXPECT_LT(second.norm(), 1e-9);
}

}  // namespace
}  // namespace mien::motion
