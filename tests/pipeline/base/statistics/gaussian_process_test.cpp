#include "pipeline/base/statistics/gaussian_process.h"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::vector<std::vector<int>> one_family = {{0, 1}};
const std::vector<std::vector<int>> two_families = {{0, 1}, {2}};

ProcessParameters parameters(std::vector<double> amplitudes, double group, double own,
                             double length) {
  ProcessParameters p{VectorXd(amplitudes.size()), std::log(group), std::log(own),
                      std::log(length)};
  for (std::size_t f = 0; f < amplitudes.size(); ++f)
    p.log_amplitude[static_cast<Eigen::Index>(f)] = std::log(amplitudes[f]);
  return p;
}

MatrixXd normal_matrix(std::mt19937_64& random, int rows, int columns) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

GroupedObservations observations(unsigned seed, int groups, int each, int columns) {
  std::mt19937_64 random(seed);
  GroupedObservations o;
  o.predictors = normal_matrix(random, groups * each, columns);
  o.values = normal_matrix(random, groups * each, 1);
  o.noise_variance = normal_matrix(random, groups * each, 1).cwiseAbs() * 0.1;
  for (int i = 0; i < groups * each; ++i) o.group.push_back(i / each);
  return o;
}

/// Covariance of two observations as the header states it, for an oracle of its own.
double covariance(const GroupedObservations& o, const std::vector<std::vector<int>>& families,
                  const ProcessParameters& p, int i, int j) {
  double sum = 0.0;
  for (std::size_t f = 0; f < families.size(); ++f) {
    double distance = 0.0;
    for (const int c : families[f])
      distance += std::pow(o.predictors(i, c) - o.predictors(j, c), 2) /
                  static_cast<double>(families[f].size());
    const double a = std::exp(p.log_amplitude[static_cast<Eigen::Index>(f)]);
    sum += a * a * std::exp(-distance / (2.0 * std::exp(2.0 * p.log_length)));
  }
  if (o.group[static_cast<std::size_t>(i)] == o.group[static_cast<std::size_t>(j)])
    sum += std::exp(2.0 * p.log_group);
  if (i == j) sum += std::exp(2.0 * p.log_own) + o.noise_variance[i];
  return sum;
}

MatrixXd covariance(const GroupedObservations& o, const std::vector<std::vector<int>>& families,
                    const ProcessParameters& p) {
  return MatrixXd::NullaryExpr(o.count(), o.count(), [&](Eigen::Index i, Eigen::Index j) {
    return covariance(o, families, p, static_cast<int>(i), static_cast<int>(j));
  });
}

double density(const VectorXd& at, const MatrixXd& covariance) {
  const double two_pi = 6.283185307179586;
  return std::exp(-0.5 * at.dot(covariance.inverse() * at)) /
         std::sqrt(std::pow(two_pi, static_cast<double>(at.size())) * covariance.determinant());
}

TEST(GaussianProcess, OfTwoObservationsIsItsClosedForm) {
  // Symmetric: both are equally far from the new one, which then is their mean, with variance
  // a² + g² + s² − k² · 2/(v + c) + (1 − 2k/(v + c))² · (v + c)/2 for C = [v c; c v].
  GroupedObservations o;
  o.predictors = MatrixXd(2, 1);
  o.predictors << -1.0, 1.0;
  o.values = Eigen::Vector2d(2.0, 5.0);
  o.noise_variance = Eigen::Vector2d(0.1, 0.1);
  o.group = {0, 1};
  const GaussianProcess process = process_with({{0}}, o, parameters({2.0}, 0.3, 0.2, 0.8));
  const ProcessPrediction p = predicted(process, Eigen::RowVectorXd::Zero(1));
  const double k = 4.0 * std::exp(-1.0 / (2.0 * 0.64));
  const double c = 4.0 * std::exp(-4.0 / (2.0 * 0.64));
  const double v = 4.0 + 0.09 + 0.04 + 0.1;
  const double rest = 1.0 - 2.0 * k / (v + c);
  EXPECT_NEAR(p.mean, 3.5, 1e-9);
  EXPECT_NEAR(p.variance, 4.0 + 0.09 + 0.04 - 2.0 * k * k / (v + c) + rest * rest * (v + c) / 2.0,
              1e-8);
}

TEST(GaussianProcess, PredictsWhatNumericalIntegrationOfThePosteriorDoes) {
  GroupedObservations all = observations(3, 4, 1, 3);  // the last one is to be predicted
  all.noise_variance[3] = 0.0;
  const ProcessParameters p = parameters({0.9, 0.6}, 0.4, 0.3, 1.2);
  const MatrixXd joint = covariance(all, two_families, p);
  double mass = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (double value = -9.0; value <= 9.0; value += 0.05) {
    for (double m = -12.0; m <= 12.0; m += 0.1) {
      VectorXd at = all.values.array() - m;
      at[3] = value - m;
      const double d = density(at, joint);
      mass += d;
      first += d * value;
      second += d * value * value;
    }
  }
  GroupedObservations known = all;
  known.predictors.conservativeResize(3, 3);
  known.values.conservativeResize(3);
  known.noise_variance.conservativeResize(3);
  known.group.pop_back();
  const ProcessPrediction found =
      predicted(process_with(two_families, known, p), all.predictors.row(3));
  const double mean = first / mass;
  EXPECT_NEAR(found.mean, mean, 1e-5);
  EXPECT_NEAR(found.variance, second / mass - mean * mean, 1e-4);
}

// An observation changes the joint distribution by its covariances with it, whatever its value.
TEST(GaussianProcess, IsJointlyPredictedAsWithOneObservationMore) {
  const GroupedObservations all = observations(5, 6, 1, 3);
  GroupedObservations known = all;
  known.predictors.conservativeResize(5, 3);
  known.values.conservativeResize(5);
  known.noise_variance.conservativeResize(5);
  known.group.pop_back();
  const ProcessParameters p = parameters({0.9, 0.6}, 0.4, 0.3, 1.2);
  const GaussianProcess process = process_with(two_families, known, p);
  MatrixXd places = observations(11, 4, 1, 3).predictors;
  places.row(0) = all.predictors.row(5);
  const JointPrediction before = jointly_predicted(process, places);
  EXPECT_NEAR(deviation_variance(process.parameters), 0.16 + 0.09, 1e-12);
  for (int i = 0; i < 4; ++i) {
    const ProcessPrediction alone = predicted(process, places.row(i));
    EXPECT_NEAR(before.mean[i], alone.mean, 1e-12);
    EXPECT_NEAR(before.covariance(i, i) + 0.25, alone.variance, 1e-12);
  }
  const VectorXd column = before.covariance.col(0);
  const double variance = column[0] + 0.25 + all.noise_variance[5];
  const JointPrediction after = jointly_predicted(process_with(two_families, all, p), places);
  const VectorXd mean = before.mean + column * (all.values[5] - before.mean[0]) / variance;
  EXPECT_LT((after.mean - mean).cwiseAbs().maxCoeff(), 1e-6);
  const MatrixXd covariance = before.covariance - column * column.transpose() / variance;
  EXPECT_LT((after.covariance - covariance).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(GaussianProcess, LikelihoodIsTheIntegralOverTheConstant) {
  const GroupedObservations o = observations(4, 3, 2, 2);
  const ProcessParameters p = parameters({0.8}, 0.5, 0.3, 0.9);
  const MatrixXd c = covariance(o, one_family, p);
  double integral = 0.0;
  for (double m = -15.0; m <= 15.0; m += 0.01) integral += 0.01 * density(o.values.array() - m, c);
  const double constant = 0.5 * (o.count() - 1) * std::log(6.283185307179586);
  EXPECT_NEAR(log_likelihood(one_family, o, p), std::log(integral) + constant, 1e-6);
}

TEST(GaussianProcess, FittedParametersAreAMaximum) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const GroupedObservations o = observations(seed, 8, 2, 3);
    const GaussianProcess best = fit_process(two_families, o);
    for (int k = 0; k < 5; ++k) {
      for (const double step : {-0.05, 0.05}) {
        ProcessParameters moved = best.parameters;
        if (k < 2) moved.log_amplitude[k] += step;
        if (k == 2) moved.log_group += step;
        if (k == 3) moved.log_own += step;
        if (k == 4) moved.log_length += step;
        EXPECT_LT(process_with(two_families, o, moved).log_evidence, best.log_evidence)
            << "parameter " << k << " of seed " << seed;
      }
    }
  }
}

TEST(GaussianProcess, FollowsShiftsScalesAndOrder) {
  const GroupedObservations o = observations(6, 8, 2, 3);
  const Eigen::RowVectorXd at = Eigen::RowVector3d(0.3, -0.4, 0.8);
  const ProcessPrediction before = predicted(fit_process(two_families, o), at);
  GroupedObservations moved = o;
  moved.values = (3.0 * o.values).array() + 10.0;
  moved.noise_variance *= 9.0;
  moved.predictors.array() += 5.0;
  const ProcessPrediction after = predicted(fit_process(two_families, moved), at.array() + 5.0);
  EXPECT_NEAR(after.mean, 3.0 * before.mean + 10.0, 1e-4);
  EXPECT_NEAR(after.variance, 9.0 * before.variance, 1e-4);
  GroupedObservations turned = o;
  for (int i = 0; i < o.count(); ++i) {
    const int j = o.count() - 1 - i;
    turned.predictors.row(i) = o.predictors.row(j);
    turned.values[i] = o.values[j];
    turned.noise_variance[i] = o.noise_variance[j];
    turned.group[static_cast<std::size_t>(i)] = 100 - o.group[static_cast<std::size_t>(j)];
  }
  EXPECT_NEAR(predicted(fit_process(two_families, turned), at).mean, before.mean, 1e-6);
}

TEST(GaussianProcess, TakesOfAGroupCountLessThanIndependentObservations) {
  GroupedObservations takes = observations(7, 5, 4, 2);
  for (int i = 0; i < takes.count(); ++i)
    takes.predictors.row(i) = takes.predictors.row(i / 4 * 4);  // the same place for all takes
  GroupedObservations independent = takes;
  for (int i = 0; i < takes.count(); ++i) independent.group[static_cast<std::size_t>(i)] = i;
  const ProcessParameters p = parameters({1.0}, 0.8, 0.3, 1.0);
  const Eigen::RowVectorXd at = takes.predictors.row(0);
  EXPECT_GT(predicted(process_with(one_family, takes, p), at).variance,
            1.1 * predicted(process_with(one_family, independent, p), at).variance);
}

// Each observation is left out by making the process anew from the others.
TEST(GaussianProcess, LeavesOutOneObservationAtATime) {
  const GroupedObservations o = observations(11, 9, 1, 3);
  const ProcessParameters p = parameters({1.2, 0.5}, 0.3, 0.2, 0.8);
  const auto left_out = left_out_predictions(process_with(two_families, o, p));
  ASSERT_EQ(left_out.size(), 9u);
  for (int i = 0; i < 9; ++i) {
    std::vector<int> kept;
    for (int j = 0; j < 9; ++j)
      if (j != i) kept.push_back(j);
    GroupedObservations others;
    others.predictors = o.predictors(kept, Eigen::all);
    others.values = o.values(kept);
    others.noise_variance = o.noise_variance(kept);
    others.group = kept;
    const ProcessPrediction expected =
        predicted(process_with(two_families, others, p), o.predictors.row(i));
    EXPECT_NEAR(left_out[static_cast<std::size_t>(i)].mean, expected.mean, 1e-6);
    EXPECT_NEAR(left_out[static_cast<std::size_t>(i)].variance,
                expected.variance + o.noise_variance[i], 1e-6);
  }
}

TEST(GaussianProcess, FarFromAllObservationsKnowsTheConstantOnly) {
  const GroupedObservations o = observations(8, 6, 2, 2);
  const ProcessParameters p = parameters({1.0}, 0.5, 0.3, 1.0);
  const GaussianProcess process = process_with(one_family, o, p);
  const ProcessPrediction far = predicted(process, Eigen::RowVector2d(1e3, 1e3));
  EXPECT_NEAR(far.mean, process.constant, 1e-12);
  EXPECT_NEAR(far.variance, 1.0 + 0.25 + 0.09 + 1.0 / process.inverse.sum(), 1e-9);
}

TEST(GaussianProcess, NinetyPercentIntervalsCoverSlightlyLess) {
  // Worlds drawn from the priors of fit_process (sd 1), each with a new group to predict.
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  int covered = 0;
  constexpr int worlds = 400;
  for (int world = 0; world < worlds; ++world) {
    GroupedObservations o = observations(static_cast<unsigned>(1000 + world), 13, 2, 3);
    const double half = -0.5 * std::log(2.0);
    ProcessParameters p{VectorXd(2), normal(random) - 1.0, normal(random) - 1.5,
                        0.5 * normal(random)};
    for (const int f : {0, 1}) p.log_amplitude[f] = normal(random) - 0.35 + half;
    o.noise_variance.tail(2).setZero();
    const MatrixXd c = covariance(o, two_families, p);
    o.values = c.llt().matrixL() * normal_matrix(random, o.count(), 1);
    const double truth = o.values[24];
    const Eigen::RowVectorXd at = o.predictors.row(24);
    o.predictors.conservativeResize(24, 3);
    o.values.conservativeResize(24);
    o.noise_variance.conservativeResize(24);
    o.group.resize(24);
    const ProcessPrediction found = predicted(fit_process(two_families, o), at);
    if (std::abs(truth - found.mean) <= 1.645 * std::sqrt(found.variance)) ++covered;
  }
  // The most probable parameters stand for all: the intervals are slightly too narrow.
  EXPECT_GT(covered, 0.80 * worlds);
  EXPECT_LT(covered, 0.93 * worlds);
}

}  // namespace
}  // namespace mien::pipeline
