#include "pipeline/base/statistics/ridge_regression.h"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

struct Sample {
  Eigen::MatrixXd predictors;
  Eigen::VectorXd values;
};

/// y = 3 + 2·x₀ − x₁ + noise; the other predictors say nothing.
Sample linear_sample(unsigned seed, int count, int predictors, double noise) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Sample sample{Eigen::MatrixXd(count, predictors), Eigen::VectorXd(count)};
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < predictors; ++k) sample.predictors(i, k) = 5.0 + normal(random);
    sample.values[i] =
        3.0 + 2.0 * sample.predictors(i, 0) - sample.predictors(i, 1) + noise * normal(random);
  }
  return sample;
}

std::vector<int> each_alone(int count) {
  std::vector<int> group(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) group[static_cast<std::size_t>(i)] = i;
  return group;
}

TEST(RidgeRegression, WithHardlyAnyPenaltyIsLeastSquares) {
  const Sample s = linear_sample(1, 40, 3, 0.5);
  Eigen::MatrixXd design(40, 4);
  design << Eigen::VectorXd::Ones(40), s.predictors;
  const Eigen::VectorXd b = design.colPivHouseholderQr().solve(s.values);
  const RidgeModel model = fit_ridge(s.predictors, s.values, 1e-9);
  for (int i = 0; i < 40; ++i) {
    EXPECT_NEAR(predicted(model, s.predictors.row(i)), design.row(i) * b, 1e-8);
  }
}

TEST(RidgeRegression, ShrinksOnePredictorByTheKnownShare) {
  // One standardised predictor: b = Σzy / (n + penalty).
  const Eigen::MatrixXd x = linear_sample(2, 25, 2, 0.0).predictors.leftCols(1);
  const Eigen::VectorXd y = 4.0 * x.col(0);
  const double spread = std::sqrt((x.array() - x.mean()).square().sum() / 25.0);
  EXPECT_NEAR(fit_ridge(x, y, 25.0).coefficients[0], 0.5 * 4.0 * spread, 1e-10);
  EXPECT_NEAR(fit_ridge(x, y, 1e12).coefficients[0], 0.0, 1e-6);
}

TEST(RidgeRegression, UnitsOfThePredictorsDoNotMatter) {
  const Sample s = linear_sample(3, 20, 30, 0.5);
  Sample other = s;
  other.predictors.col(0) *= 1000.0;
  other.predictors.col(4).array() -= 77.0;
  const RidgeModel a = fit_ridge(s.predictors, s.values, 5.0);
  const RidgeModel b = fit_ridge(other.predictors, other.values, 5.0);
  for (int i = 0; i < 20; ++i) {
    EXPECT_NEAR(predicted(a, s.predictors.row(i)), predicted(b, other.predictors.row(i)), 1e-9);
  }
}

TEST(RidgeRegression, AConstantPredictorSaysNothing) {
  Sample s = linear_sample(4, 20, 3, 0.1);
  s.predictors.col(2).setConstant(1e3);
  const RidgeModel model = fit_ridge(s.predictors, s.values, 1.0);
  Eigen::RowVectorXd moved = s.predictors.row(0);
  moved[2] = -50.0;
  EXPECT_DOUBLE_EQ(predicted(model, moved), predicted(model, s.predictors.row(0)));
}

TEST(RidgeRegression, LeverageIsTheOwnWeightOfAnObservation) {
  const Sample s = linear_sample(5, 15, 20, 0.5);
  const RidgeModel model = fit_ridge(s.predictors, s.values, 4.0);
  for (int i = 0; i < 15; ++i) {
    Eigen::VectorXd raised = s.values;
    raised[i] += 1.0;
    const RidgeModel other = fit_ridge(s.predictors, raised, 4.0);
    const double weight =
        predicted(other, s.predictors.row(i)) - predicted(model, s.predictors.row(i));
    EXPECT_NEAR(leverage(model, s.predictors.row(i)), weight, 1e-10);
  }
  const Eigen::RowVectorXd far = s.predictors.row(0) * 10.0;
  EXPECT_GT(leverage(model, far), 1.0);
}

TEST(RidgeRegression, ChoosesThePenaltyThatRefittingChooses) {
  const Sample s = linear_sample(6, 18, 40, 1.0);
  std::vector<int> pairs;
  for (int i = 0; i < 18; ++i) pairs.push_back(i / 2);
  for (const std::vector<int>& group : {each_alone(18), pairs}) {
    // Standardised once, as the closed form is.
    Eigen::MatrixXd z = s.predictors.rowwise() - s.predictors.colwise().mean();
    for (int k = 0; k < 40; ++k) z.col(k) /= std::sqrt(z.col(k).squaredNorm() / 18.0);
    double best = 0.0;
    double limit = 0.0;
    double least = 1e300;
    const auto choices = penalty_choices(18);
    std::vector<double> sums;
    for (const double penalty : choices) {
      std::vector<double> errors;
      for (int out = 0; out <= group.back(); ++out) {
        std::vector<int> kept, left;
        for (int i = 0; i < 18; ++i) {
          (group[static_cast<std::size_t>(i)] == out ? left : kept).push_back(i);
        }
        // Intercept not penalised, on the fixed standardisation.
        Eigen::MatrixXd design(kept.size(), 41);
        design << Eigen::VectorXd::Ones(static_cast<Eigen::Index>(kept.size())),
            z(kept, Eigen::all);
        Eigen::MatrixXd normal = design.transpose() * design;
        normal.diagonal().tail(40).array() += penalty;
        const Eigen::VectorXd b =
            normal.ldlt().solve(design.transpose() * Eigen::VectorXd(s.values(kept)));
        errors.push_back(0.0);
        for (const int i : left) {
          errors.back() += std::pow(s.values[i] - b[0] - z.row(i).dot(b.tail(40)), 2);
        }
      }
      double sum = 0.0;
      double squares = 0.0;
      for (const double e : errors) sum += e;
      const auto n = static_cast<double>(errors.size());
      for (const double e : errors) squares += std::pow(e - sum / n, 2);
      sums.push_back(sum);
      if (sum >= least) continue;
      least = sum;
      limit = sum + std::sqrt(n) * std::sqrt(squares / (n - 1));
    }
    for (std::size_t k = 0; k < choices.size(); ++k) {
      if (sums[k] <= limit) best = choices[k];
    }
    EXPECT_DOUBLE_EQ(best_penalty(s.predictors, s.values, group), best);
  }
}

TEST(RidgeRegression, CrossValidationSeesALawAndNoLawInNoise) {
  const Sample law = linear_sample(7, 40, 10, 0.3);
  const auto group = each_alone(40);
  const CrossValidation found = cross_validate(law.predictors, law.values, group);
  EXPECT_GT(found.r_squared(law.values), 0.9);
  EXPECT_LT(found.rmse(law.values), 0.5);
  const Sample noise = linear_sample(8, 40, 10, 0.0);
  const Eigen::VectorXd unrelated = linear_sample(9, 40, 10, 0.0).values;
  EXPECT_LT(cross_validate(noise.predictors, unrelated, group).r_squared(unrelated), 0.2);
}

TEST(RidgeRegression, TwinsMustBeLeftOutTogether) {
  // Values without any law, each observed twice: only a twin can tell.
  std::mt19937_64 random(10);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd predictors(30, 20);
  Eigen::VectorXd values(30);
  std::vector<int> pairs;
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 20; ++k) {
      predictors(i, k) = i % 2 ? predictors(i - 1, k) + 0.01 * normal(random) : normal(random);
    }
    values[i] = i % 2 ? values[i - 1] : normal(random);
    pairs.push_back(i / 2);
  }
  EXPECT_GT(cross_validate(predictors, values, each_alone(30)).r_squared(values), 0.8);
  EXPECT_LT(cross_validate(predictors, values, pairs).r_squared(values), 0.3);
}

TEST(RidgeRegression, ALeftOutValueHasNoPartInItsPrediction) {
  Sample s = linear_sample(11, 12, 5, 0.5);
  const auto group = each_alone(12);
  const double before = cross_validate(s.predictors, s.values, group).predicted[3];
  s.values[3] += 1000.0;
  EXPECT_DOUBLE_EQ(cross_validate(s.predictors, s.values, group).predicted[3], before);
}

}  // namespace
}  // namespace mien::pipeline
