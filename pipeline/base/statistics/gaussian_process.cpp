#include "pipeline/base/statistics/gaussian_process.h"

#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace mien::pipeline {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Families = std::vector<std::vector<int>>;

constexpr double length_spread = 0.5;  ///< of the prior of the length; 1 for all other parameters
constexpr double least_variance = 1e-10;  ///< of the values' variance, keeps the matrix positive

/// Mean squared differences of a family's predictors.
MatrixXd squared_distances(const MatrixXd& a, const MatrixXd& b, const std::vector<int>& columns) {
  MatrixXd result = MatrixXd::Zero(a.rows(), b.rows());
  for (const int c : columns)
    for (Index j = 0; j < b.rows(); ++j)
      result.col(j).array() += (a.col(c).array() - b(j, c)).square();
  return result / static_cast<double>(columns.size());
}

double spread_of(const VectorXd& values) {
  const double variance =
      (values.array() - values.mean()).square().sum() / static_cast<double>(values.size());
  return std::max(std::sqrt(variance), 1e-9);
}

/// What stays the same for all parameters.
struct Problem {
  const GroupedObservations& observations;
  std::vector<MatrixXd> distances;  ///< squared, one a family
  MatrixXd same_group;
  VectorXd centred;  ///< values minus their mean
  double spread;

  Index families() const { return static_cast<Index>(distances.size()); }
  Index size() const { return families() + 3; }
};

Problem problem_of(const Families& families, const GroupedObservations& observations) {
  Problem problem{observations, {}, {}, {}, spread_of(observations.values)};
  for (const auto& columns : families)
    problem.distances.push_back(
        squared_distances(observations.predictors, observations.predictors, columns));
  const auto count = static_cast<Index>(observations.group.size());
  problem.same_group = MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j)
      if (observations.group[static_cast<std::size_t>(i)] ==
          observations.group[static_cast<std::size_t>(j)])
        problem.same_group(i, j) = 1.0;
  problem.centred = observations.values.array() - observations.values.mean();
  return problem;
}

/// Parameters as a vector: amplitudes, group, own, length.
VectorXd vector_of(const ProcessParameters& p) {
  VectorXd theta(p.log_amplitude.size() + 3);
  theta << p.log_amplitude, p.log_group, p.log_own, p.log_length;
  return theta;
}

ProcessParameters parameters_of(const VectorXd& theta) {
  const Index n = theta.size() - 3;
  return {theta.head(n), theta[n], theta[n + 1], theta[n + 2]};
}

MatrixXd family_covariance(const MatrixXd& distances, double log_amplitude, double log_length) {
  return std::exp(2.0 * log_amplitude) *
         (distances.array() * (-0.5 * std::exp(-2.0 * log_length))).exp().matrix();
}

struct Likelihood {
  double value = 0.0;
  VectorXd gradient;
};

/// Log marginal likelihood with m integrated out, and its gradient:
/// −½ yᵀPy − ½ log|C| − ½ log(1ᵀC⁻¹1), P = C⁻¹ − C⁻¹11ᵀC⁻¹/(1ᵀC⁻¹1).
Likelihood likelihood(const Problem& problem, const VectorXd& theta) {
  const ProcessParameters p = parameters_of(theta);
  const GroupedObservations& o = problem.observations;
  const auto count = static_cast<Index>(o.values.size());
  std::vector<MatrixXd> parts;
  MatrixXd by_length = MatrixXd::Zero(count, count);
  MatrixXd covariance = std::exp(2.0 * p.log_group) * problem.same_group;
  for (Index f = 0; f < problem.families(); ++f) {
    const MatrixXd& distances = problem.distances[static_cast<std::size_t>(f)];
    parts.push_back(family_covariance(distances, p.log_amplitude[f], p.log_length));
    by_length += parts.back().cwiseProduct(distances) * std::exp(-2.0 * p.log_length);
    covariance += parts.back();
  }
  const double own = std::exp(2.0 * p.log_own);
  covariance.diagonal().array() += own + least_variance * problem.spread * problem.spread;
  covariance.diagonal() += o.noise_variance;
  const Eigen::LLT<MatrixXd> factors(covariance);
  if (factors.info() != Eigen::Success)
    return {-std::numeric_limits<double>::infinity(), VectorXd::Zero(theta.size())};
  const MatrixXd inverse = factors.solve(MatrixXd::Identity(count, count));
  const VectorXd ones = VectorXd::Ones(count);
  const VectorXd row = inverse * ones;
  const double sum = row.sum();
  const MatrixXd projected = inverse - row * row.transpose() / sum;
  const VectorXd a = projected * problem.centred;
  const double log_determinant = 2.0 * MatrixXd(factors.matrixL()).diagonal().array().log().sum();
  Likelihood result;
  result.value = -0.5 * (problem.centred.dot(a) + log_determinant + std::log(sum));
  const auto along = [&](const MatrixXd& derivative) {
    return 0.5 * (a.dot(derivative * a) - projected.cwiseProduct(derivative).sum());
  };
  result.gradient.resize(theta.size());
  const Index n = problem.families();
  for (Index f = 0; f < n; ++f)
    result.gradient[f] = 2.0 * along(parts[static_cast<std::size_t>(f)]);
  result.gradient[n] = 2.0 * std::exp(2.0 * p.log_group) * along(problem.same_group);
  result.gradient[n + 1] = own * (a.squaredNorm() - projected.trace());
  result.gradient[n + 2] = along(by_length);
  return result;
}

/// Normal prior of the parameters.
struct Prior {
  VectorXd mean, spread;
};

Prior prior_of(const Problem& problem) {
  const Index n = problem.families();
  Prior prior{vector_of(usual_parameters(problem.distances.size(), problem.spread)),
              VectorXd::Ones(problem.size())};
  prior.spread[n + 2] = length_spread;
  return prior;
}

Likelihood posterior(const Problem& problem, const Prior& prior, const VectorXd& theta) {
  Likelihood result = likelihood(problem, theta);
  const VectorXd off = (theta - prior.mean).cwiseQuotient(prior.spread);
  result.value -= 0.5 * off.squaredNorm();
  result.gradient -= off.cwiseQuotient(prior.spread);
  return result;
}

/// Maximum of the posterior from the prior's mean: BFGS with backtracking (Nocedal and Wright 2006,
/// algorithm 6.1).
VectorXd most_probable(const Problem& problem, const Prior& prior) {
  constexpr int most_steps = 200;
  constexpr double flat = 1e-6;
  VectorXd theta = prior.mean;
  Likelihood at = posterior(problem, prior, theta);
  MatrixXd inverse_hessian = prior.spread.cwiseAbs2().asDiagonal();
  for (int step = 0; step < most_steps && at.gradient.cwiseAbs().maxCoeff() > flat; ++step) {
    VectorXd direction = inverse_hessian * at.gradient;
    const double longest = direction.cwiseAbs().maxCoeff();
    if (longest > 1.0) direction /= longest;
    double share = 1.0;
    const double slope = direction.dot(at.gradient);
    Likelihood next = posterior(problem, prior, theta + direction);
    while (next.value < at.value + 1e-4 * share * slope && share > 1e-8) {
      share *= 0.5;
      next = posterior(problem, prior, theta + share * direction);
    }
    if (share <= 1e-8) break;
    const VectorXd moved = share * direction;
    const VectorXd change = at.gradient - next.gradient;
    const double curvature = moved.dot(change);
    if (curvature > 1e-12) {
      const VectorXd applied = inverse_hessian * change;
      inverse_hessian +=
          (1.0 + change.dot(applied) / curvature) / curvature * (moved * moved.transpose()) -
          (applied * moved.transpose() + moved * applied.transpose()) / curvature;
    }
    theta += moved;
    at = next;
  }
  return theta;
}

}  // namespace

MatrixXd Standardisation::of(const MatrixXd& predictors) const {
  MatrixXd z = predictors.rowwise() - mean;
  for (Index k = 0; k < z.cols(); ++k) z.col(k) *= spread[k] > 0.0 ? 1.0 / spread[k] : 0.0;
  return z;
}

Standardisation standardisation_of(const MatrixXd& predictors) {
  Standardisation result;
  result.mean = predictors.colwise().mean();
  result.spread = ((predictors.rowwise() - result.mean).array().square().colwise().sum() /
                   static_cast<double>(predictors.rows()))
                      .sqrt();
  for (Index k = 0; k < predictors.cols(); ++k)
    if (result.spread[k] < 1e-9 * (1.0 + std::abs(result.mean[k]))) result.spread[k] = 0.0;
  return result;
}

ProcessParameters usual_parameters(std::size_t families, double spread) {
  const double sd = std::log(spread);
  const auto n = static_cast<Index>(families);
  return {VectorXd::Constant(n, sd - 0.35 - 0.5 * std::log(static_cast<double>(n))), sd - 1.0,
          sd - 1.5, 0.0};
}

double log_likelihood(const Families& families, const GroupedObservations& observations,
                      const ProcessParameters& parameters) {
  return likelihood(problem_of(families, observations), vector_of(parameters)).value;
}

GaussianProcess process_with(const Families& families, const GroupedObservations& observations,
                             const ProcessParameters& parameters) {
  assert(observations.count() >= 2 && !families.empty());
  const Problem problem = problem_of(families, observations);
  const auto count = static_cast<Index>(observations.count());
  GaussianProcess process{families, parameters, observations, 0.0, {}, {}, 0.0};
  MatrixXd covariance = std::exp(2.0 * parameters.log_group) * problem.same_group;
  for (Index f = 0; f < problem.families(); ++f)
    covariance += family_covariance(problem.distances[static_cast<std::size_t>(f)],
                                    parameters.log_amplitude[f], parameters.log_length);
  covariance.diagonal().array() +=
      std::exp(2.0 * parameters.log_own) + least_variance * problem.spread * problem.spread;
  covariance.diagonal() += observations.noise_variance;
  process.inverse = covariance.llt().solve(MatrixXd::Identity(count, count));
  const double sum = process.inverse.sum();
  process.constant = process.inverse.rowwise().sum().dot(observations.values) / sum;
  process.weights = process.inverse * (observations.values.array() - process.constant).matrix();
  const VectorXd theta = vector_of(parameters);
  process.log_evidence = posterior(problem, prior_of(problem), theta).value;
  return process;
}

GaussianProcess fit_process(const Families& families, const GroupedObservations& observations) {
  assert(observations.count() >= 2 && !families.empty());
  const Problem problem = problem_of(families, observations);
  return process_with(families, observations,
                      parameters_of(most_probable(problem, prior_of(problem))));
}

std::vector<ProcessPrediction> left_out_predictions(const GaussianProcess& process) {
  assert(process.observations.count() >= 3);
  const VectorXd row = process.inverse.rowwise().sum();
  const VectorXd precision = process.inverse.diagonal() - row.cwiseAbs2() / process.inverse.sum();
  std::vector<ProcessPrediction> predictions;
  for (Index i = 0; i < precision.size(); ++i)
    predictions.push_back(
        {process.observations.values[i] - process.weights[i] / precision[i], 1.0 / precision[i]});
  return predictions;
}

double deviation_variance(const ProcessParameters& parameters) {
  return std::exp(2.0 * parameters.log_group) + std::exp(2.0 * parameters.log_own);
}

JointPrediction prior_prediction(const Families& families, const ProcessParameters& parameters,
                                 const MatrixXd& predictors, double constant_variance) {
  MatrixXd covariance = MatrixXd::Constant(predictors.rows(), predictors.rows(), constant_variance);
  for (std::size_t f = 0; f < families.size(); ++f)
    covariance +=
        family_covariance(squared_distances(predictors, predictors, families[f]),
                          parameters.log_amplitude[static_cast<Index>(f)], parameters.log_length);
  return {VectorXd::Zero(predictors.rows()), std::move(covariance)};
}

JointPrediction jointly_predicted(const GaussianProcess& process, const MatrixXd& predictors) {
  const ProcessParameters& p = process.parameters;
  MatrixXd shared = MatrixXd::Zero(process.observations.count(), predictors.rows());
  MatrixXd covariance = MatrixXd::Zero(predictors.rows(), predictors.rows());
  for (std::size_t f = 0; f < process.families.size(); ++f) {
    const auto& columns = process.families[f];
    const double amplitude = p.log_amplitude[static_cast<Index>(f)];
    shared +=
        family_covariance(squared_distances(process.observations.predictors, predictors, columns),
                          amplitude, p.log_length);
    covariance += family_covariance(squared_distances(predictors, predictors, columns), amplitude,
                                    p.log_length);
  }
  const MatrixXd solved = process.inverse * shared;
  const VectorXd of_constant = 1.0 - solved.colwise().sum().transpose().array();
  covariance -= shared.transpose() * solved;
  covariance += of_constant * of_constant.transpose() / process.inverse.sum();
  return {(shared.transpose() * process.weights).array() + process.constant, covariance};
}

ProcessPrediction predicted(const GaussianProcess& process, const Eigen::RowVectorXd& predictors) {
  const JointPrediction joint = jointly_predicted(process, predictors);
  return {joint.mean[0], joint.covariance(0, 0) + deviation_variance(process.parameters)};
}

}  // namespace mien::pipeline
