#include "pipeline/base/statistics/ridge_regression.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "motion/math/linear_system.h"
#include "motion/math/singular_values.h"

namespace mien::pipeline {

namespace {

constexpr double least_spread = 1e-9;

Eigen::RowVectorXd standardised(const RidgeModel& model, const Eigen::RowVectorXd& predictors) {
  Eigen::RowVectorXd z = predictors - model.mean;
  for (Eigen::Index k = 0; k < z.size(); ++k)
    z[k] = model.spread[k] > 0.0 ? z[k] / model.spread[k] : 0.0;
  return z;
}

/// Mean and spread of the predictors, and the predictors by them.
Eigen::MatrixXd standardise(const Eigen::MatrixXd& predictors, RidgeModel& model) {
  const auto count = static_cast<double>(predictors.rows());
  model.observations = static_cast<int>(predictors.rows());
  model.mean = predictors.colwise().mean();
  const Eigen::MatrixXd centred = predictors.rowwise() - model.mean;
  model.spread = (centred.colwise().squaredNorm() / count).cwiseSqrt();
  const Eigen::RowVectorXd size = model.mean.cwiseAbs().cwiseMax(1.0);
  for (Eigen::Index k = 0; k < model.spread.size(); ++k)
    if (model.spread[k] < least_spread * size[k]) model.spread[k] = 0.0;
  Eigen::MatrixXd z(predictors.rows(), predictors.cols());
  for (Eigen::Index i = 0; i < z.rows(); ++i) z.row(i) = standardised(model, predictors.row(i));
  return z;
}

std::vector<std::vector<Eigen::Index>> members_of(std::span<const int> group) {
  std::vector<int> names(group.begin(), group.end());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::vector<std::vector<Eigen::Index>> members(names.size());
  for (std::size_t i = 0; i < group.size(); ++i) {
    const auto at = std::lower_bound(names.begin(), names.end(), group[i]) - names.begin();
    members[static_cast<std::size_t>(at)].push_back(static_cast<Eigen::Index>(i));
  }
  return members;
}

/// Squared errors of groups predicted without them: (I − H_GG)⁻¹ e_G, H the hat matrix.
Eigen::VectorXd held_out_errors(const Eigen::MatrixXd& hat, const Eigen::VectorXd& values,
                                const std::vector<std::vector<Eigen::Index>>& groups) {
  const Eigen::VectorXd residuals = values - hat * values;
  Eigen::VectorXd errors(static_cast<Eigen::Index>(groups.size()));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Eigen::MatrixXd own = hat(groups[g], groups[g]);
    const Eigen::VectorXd e = residuals(groups[g]);
    const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(own.rows(), own.cols()) - own;
    errors[static_cast<Eigen::Index>(g)] = motion::LinearSystem(rest).solve(e).squaredNorm();
  }
  return errors;
}

/// Standard error of the sum.
double standard_error(const Eigen::VectorXd& errors) {
  const auto n = static_cast<double>(errors.size());
  if (n < 2) return 0.0;
  return std::sqrt(n / (n - 1.0) * (errors.array() - errors.mean()).square().sum());
}

double root_mean_square(const Eigen::VectorXd& errors) {
  return std::sqrt(errors.squaredNorm() / static_cast<double>(errors.size()));
}

}  // namespace

RidgeModel fit_ridge(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                     double penalty) {
  assert(predictors.rows() == values.size() && values.size() >= 2 && penalty > 0.0);
  RidgeModel model;
  const Eigen::MatrixXd z = standardise(predictors, model);
  model.penalty = penalty;
  model.intercept = values.mean();
  const auto unit = Eigen::MatrixXd::Identity(z.cols(), z.cols());
  const Eigen::MatrixXd normal = z.transpose() * z + penalty * unit;
  model.inverse = motion::inverse_of_positive(normal);
  model.coefficients =
      (model.inverse * (z.transpose() * (values.array() - model.intercept).matrix())).transpose();
  return model;
}

double predicted(const RidgeModel& model, const Eigen::RowVectorXd& predictors) {
  return model.intercept + model.coefficients.dot(standardised(model, predictors));
}

double leverage(const RidgeModel& model, const Eigen::RowVectorXd& predictors) {
  const Eigen::RowVectorXd z = standardised(model, predictors);
  return 1.0 / model.observations + z * model.inverse * z.transpose();
}

std::vector<double> penalty_choices(int observations) {
  constexpr int steps = 24;
  std::vector<double> choices;
  for (int i = 0; i <= steps; ++i)
    choices.push_back(observations * std::pow(10.0, -3.0 + 6.0 * i / steps));
  return choices;
}

double best_penalty(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                    std::span<const int> group) {
  RidgeModel model;
  const Eigen::MatrixXd z = standardise(predictors, model);
  const motion::SingularValues svd = motion::singular_values(z);
  const Eigen::VectorXd squares = svd.values.cwiseAbs2();
  const auto groups = members_of(group);
  const std::vector<double> penalties = penalty_choices(model.observations);
  std::vector<double> sums;
  double limit = std::numeric_limits<double>::infinity();
  double least = limit;
  for (const double penalty : penalties) {
    const Eigen::VectorXd shrinkage = (squares.array() / (squares.array() + penalty)).matrix();
    Eigen::MatrixXd hat = svd.u * shrinkage.asDiagonal() * svd.u.transpose();
    hat.array() += 1.0 / model.observations;
    const Eigen::VectorXd errors = held_out_errors(hat, values, groups);
    sums.push_back(errors.sum());
    if (sums.back() >= least) continue;
    least = sums.back();
    limit = least + standard_error(errors);
  }
  const auto simplest =
      std::find_if(sums.rbegin(), sums.rend(), [limit](double sum) { return sum <= limit; });
  return penalties[static_cast<std::size_t>(sums.rend() - simplest) - 1];
}

double CrossValidation::rmse(const Eigen::VectorXd& values) const {
  return root_mean_square(values - predicted);
}

double CrossValidation::mean_rmse(const Eigen::VectorXd& values) const {
  return root_mean_square(values - mean_predicted);
}

double CrossValidation::r_squared(const Eigen::VectorXd& values) const {
  return 1.0 - (values - predicted).squaredNorm() / (values - mean_predicted).squaredNorm();
}

CrossValidation cross_validate(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                               std::span<const int> group) {
  CrossValidation result;
  result.predicted.resize(values.size());
  result.mean_predicted.resize(values.size());
  result.penalty.resize(values.size());
  const auto groups = members_of(group);
  assert(groups.size() >= 2);
  for (const auto& left_out : groups) {
    std::vector<Eigen::Index> kept;
    std::vector<int> training_group;
    const int out = group[static_cast<std::size_t>(left_out.front())];
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (group[i] == out) continue;
      kept.push_back(static_cast<Eigen::Index>(i));
      training_group.push_back(group[i]);
    }
    const Eigen::MatrixXd seen = predictors(kept, Eigen::all);
    const Eigen::VectorXd known = values(kept);
    const RidgeModel model = fit_ridge(seen, known, best_penalty(seen, known, training_group));
    for (const Eigen::Index i : left_out) {
      result.predicted[i] = predicted(model, predictors.row(i));
      result.mean_predicted[i] = known.mean();
      result.penalty[i] = model.penalty;
    }
  }
  return result;
}

}  // namespace mien::pipeline
