#include "pipeline/base/statistics/pair_posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double logistic(double x) {
  return x >= 0.0 ? 1.0 / (1.0 + std::exp(-x)) : std::exp(x) / (1.0 + std::exp(x));
}

/// log(1 / (1 + exp(−x))).
double log_logistic(double x) {
  return x >= 0.0 ? -std::log1p(std::exp(-x)) : x - std::log1p(std::exp(x));
}

double log_posterior(const std::vector<PairCount>& counts, const VectorXd& worths, double prior) {
  double sum = -0.5 * worths.squaredNorm() / (prior * prior);
  for (const PairCount& count : counts) {
    const double difference =
        worths[static_cast<Index>(count.first)] - worths[static_cast<Index>(count.second)];
    sum += (count.first_wins + 0.5 * count.ties) * log_logistic(difference) +
           (count.second_wins + 0.5 * count.ties) * log_logistic(-difference);
  }
  return sum;
}

/// Gradient of the log posterior, and its second derivative with the opposite sign.
struct Slope {
  VectorXd gradient;
  MatrixXd information;
};

Slope slope_at(const std::vector<PairCount>& counts, const VectorXd& worths, double prior) {
  const double precision = 1.0 / (prior * prior);
  Slope slope{-precision * worths, precision * MatrixXd::Identity(worths.size(), worths.size())};
  for (const PairCount& count : counts) {
    const auto i = static_cast<Index>(count.first), j = static_cast<Index>(count.second);
    if (i == j) continue;
    const double p = logistic(worths[i] - worths[j]);
    const double surplus = count.first_wins + 0.5 * count.ties - count.total() * p;
    slope.gradient[i] += surplus;
    slope.gradient[j] -= surplus;
    const double weight = count.total() * p * (1.0 - p);
    slope.information(i, i) += weight;
    slope.information(j, j) += weight;
    slope.information(i, j) -= weight;
    slope.information(j, i) -= weight;
  }
  return slope;
}

/// What comparisons of two stimuli would change: the covariances of the difference of their worths
/// with all worths, and the factor of their outer product by which the covariance falls.
struct PairUpdate {
  VectorXd column;
  double factor = 0.0;
};

PairUpdate pair_update(const PairPosterior& posterior, std::size_t first, std::size_t second,
                       double answers) {
  const auto i = static_cast<Index>(first), j = static_cast<Index>(second);
  const double weight = answers * expected_comparison(posterior, first, second).curvature;
  PairUpdate update{posterior.covariance.col(i) - posterior.covariance.col(j)};
  update.factor = weight / (1.0 + weight * (update.column[i] - update.column[j]));
  return update;
}

}  // namespace

double PairPosterior::variance() const {
  return std::max(0.0, covariance.trace() - covariance.sum() / static_cast<double>(mean.size()));
}

double PairPosterior::deviation() const {
  return std::sqrt(variance() / static_cast<double>(mean.size()));
}

PairPosterior pair_posterior_with(const std::vector<PairCount>& counts, std::size_t stimuli,
                                  double prior) {
  constexpr int most_steps = 100;
  constexpr double bound = 1e-10;
  VectorXd worths = VectorXd::Zero(static_cast<Index>(stimuli));
  double reached = log_posterior(counts, worths, prior);
  for (int n = 0; n < most_steps; ++n) {
    const Slope slope = slope_at(counts, worths, prior);
    VectorXd step = slope.information.llt().solve(slope.gradient);
    if (step.lpNorm<Eigen::Infinity>() < bound) break;
    // The log posterior is concave: steps that would decrease it are halved.
    double next = log_posterior(counts, worths + step, prior);
    for (int halved = 0; halved < 40 && next < reached - 1e-12 * std::abs(reached); ++halved) {
      step *= 0.5;
      next = log_posterior(counts, worths + step, prior);
    }
    worths += step;
    reached = next;
  }
  const Eigen::LLT<MatrixXd> factors(slope_at(counts, worths, prior).information);
  const double half_log_determinant = MatrixXd(factors.matrixL()).diagonal().array().log().sum();
  return {worths, factors.solve(MatrixXd::Identity(worths.size(), worths.size())), prior,
          reached - static_cast<double>(stimuli) * std::log(prior) - half_log_determinant};
}

PairPosterior pair_posterior(const std::vector<PairCount>& counts, std::size_t stimuli) {
  constexpr double spread = 0.7;        // of the logarithm of the prior's standard deviation
  constexpr int steps_of_a_tenth = 25;  // of the logarithm, in either direction: 0.08 to 12
  PairPosterior best;
  double most = -std::numeric_limits<double>::infinity();
  for (int step = -steps_of_a_tenth; step <= steps_of_a_tenth; ++step) {
    const double log_prior = 0.1 * step;
    PairPosterior one = pair_posterior_with(counts, stimuli, std::exp(log_prior));
    const double probability = one.log_evidence - 0.5 * log_prior * log_prior / (spread * spread);
    if (!(probability > most)) continue;
    most = probability;
    best = std::move(one);
  }
  return best;
}

ExpectedComparison expected_comparison(const PairPosterior& posterior, std::size_t first,
                                       std::size_t second) {
  // The trapezoidal rule: for smooth functions times a normal density it is almost exact.
  constexpr double widest = 6.0;
  constexpr int steps = 48;
  const auto i = static_cast<Index>(first), j = static_cast<Index>(second);
  const MatrixXd& covariance = posterior.covariance;
  const double mean = posterior.mean[i] - posterior.mean[j];
  const double deviation =
      std::sqrt(std::max(0.0, covariance(i, i) + covariance(j, j) - 2.0 * covariance(i, j)));
  double sum = 0.0, chosen = 0.0, curvature = 0.0;
  for (int step = 0; step <= steps; ++step) {
    const double z = widest * (2.0 * step / steps - 1.0);
    const double weight = std::exp(-0.5 * z * z);
    const double p = logistic(mean + deviation * z);
    sum += weight;
    chosen += weight * p;
    curvature += weight * p * (1.0 - p);
  }
  return {chosen / sum, curvature / sum};
}

double expected_gain(const PairPosterior& posterior, std::size_t first, std::size_t second,
                     double answers) {
  const PairUpdate update = pair_update(posterior, first, second, answers);
  // The column has a sum of 0, since comparisons say nothing about the sum of the worths: these are
  // variances about the mean.
  return update.factor * update.column.squaredNorm();
}

void expect_answers(PairPosterior& posterior, std::size_t first, std::size_t second,
                    double answers) {
  const PairUpdate update = pair_update(posterior, first, second, answers);
  posterior.covariance -= update.factor * update.column * update.column.transpose();
}

}  // namespace mien::pipeline
