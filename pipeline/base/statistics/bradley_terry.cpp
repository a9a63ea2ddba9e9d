#include "pipeline/base/statistics/bradley_terry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>
#include <boost/math/distributions/chi_squared.hpp>

namespace mien::pipeline {

namespace {

constexpr double no_worth = std::numeric_limits<double>::quiet_NaN();

/// Outcomes of a comparison: first, second, tie. Each has weights of the parameters λ of the first
/// stimulus, λ of the second, δ and η.
using Weights = Eigen::Matrix<double, 4, 3>;

Weights outcome_weights() {
  return (Weights() << 1.0, 0.0, 0.5,  // λ of the first
          0.0, 1.0, 0.5,               // λ of the second
          0.5, -0.5, 0.0,              // δ
          0.0, 0.0, 1.0)               // η
      .finished();
}

/// The likelihood of counts as a function of the parameters: λ of each stimulus, then δ and η where
/// the model has them.
struct PairLikelihood {
  std::vector<PairCount> counts;
  std::vector<std::size_t> group;
  std::vector<std::size_t> sizes;
  Eigen::Index order = -1;  ///< index of δ; −1 if it is not in the model
  Eigen::Index tie = -1;    ///< index of η
  Eigen::Index parameters = 0;
};

PairLikelihood likelihood_of(const std::vector<PairCount>& counts, const WinGroups& groups,
                             OrderEffect order) {
  PairLikelihood model{{}, groups.group, groups.sizes};
  bool has_ties = false;
  for (const PairCount& count : counts) {
    const bool is_within = count.first != count.second && count.total() > 0.0 &&
                           groups.group[count.first] == groups.group[count.second];
    if (is_within) model.counts.push_back(count);
    has_ties = has_ties || (is_within && count.ties > 0.0);
  }
  model.parameters = static_cast<Eigen::Index>(groups.group.size());
  if (order == OrderEffect::estimated) model.order = model.parameters++;
  if (has_ties) model.tie = model.parameters++;
  return model;
}

std::array<Eigen::Index, 4> places_of(const PairLikelihood& model, const PairCount& count) {
  return {static_cast<Eigen::Index>(count.first), static_cast<Eigen::Index>(count.second),
          model.order, model.tie};
}

/// Logarithms of the probabilities of the three outcomes; −∞ of a tie if the model has none.
Eigen::Vector3d log_probabilities(const PairLikelihood& model, const PairCount& count,
                                  const Eigen::VectorXd& at) {
  const double first = at[static_cast<Eigen::Index>(count.first)];
  const double second = at[static_cast<Eigen::Index>(count.second)];
  const double order = model.order < 0 ? 0.0 : at[model.order];
  const double none = -std::numeric_limits<double>::infinity();
  const double tie = model.tie < 0 ? none : at[model.tie] + 0.5 * (first + second);
  const Eigen::Vector3d score(first + 0.5 * order, second - 0.5 * order, tie);
  const double most = score.maxCoeff();
  double sum = std::exp(score[0] - most) + std::exp(score[1] - most);
  if (model.tie >= 0) sum += std::exp(tie - most);
  return (score.array() - most - std::log(sum)).matrix();
}

double log_likelihood(const PairLikelihood& model, const Eigen::VectorXd& at) {
  double sum = 0.0;
  for (const PairCount& count : model.counts) {
    const Eigen::Vector3d log_p = log_probabilities(model, count, at);
    sum += count.first_wins * log_p[0] + count.second_wins * log_p[1];
    if (count.ties > 0.0) sum += count.ties * log_p[2];
  }
  return sum;
}

/// First derivative of the log-likelihood, and the information matrix (minus the second).
struct Derivatives {
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;
};

Derivatives derivatives_of(const PairLikelihood& model, const Eigen::VectorXd& at) {
  Derivatives result{Eigen::VectorXd::Zero(model.parameters),
                     Eigen::MatrixXd::Zero(model.parameters, model.parameters)};
  const Weights weights = outcome_weights();
  for (const PairCount& count : model.counts) {
    const Eigen::Vector3d p = log_probabilities(model, count, at).array().exp();
    const Eigen::Vector3d seen(count.first_wins, count.second_wins, count.ties);
    const Eigen::Vector4d gradient = weights * (seen - count.total() * p);
    const Eigen::Vector4d mean = weights * p;
    const Eigen::Matrix4d information =
        count.total() * (weights * p.asDiagonal() * weights.transpose() - mean * mean.transpose());
    const std::array<Eigen::Index, 4> places = places_of(model, count);
    for (std::size_t i = 0; i < 4; ++i) {
      if (places[i] < 0) continue;
      result.gradient[places[i]] += gradient[static_cast<Eigen::Index>(i)];
      for (std::size_t k = 0; k < 4; ++k)
        if (places[k] >= 0)
          result.information(places[i], places[k]) +=
              information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
    }
  }
  return result;
}

/// The information with a term for the sum of each group's worths, about which the comparisons say
/// nothing: without it the matrix is singular, and with it the steps keep the sums at zero.
struct Completed {
  Eigen::LDLT<Eigen::MatrixXd> solver;
  double term = 1.0;  ///< what was added to each element of a group
  bool is_regular = false;
};

Completed completed(const PairLikelihood& model, Eigen::MatrixXd information) {
  // Below this share of the largest, an eigenvalue is that of a difference without bound.
  constexpr double least_share = 1e-11;
  Completed result;
  result.term = std::max(information.diagonal().maxCoeff(), 1e-3);
  for (std::size_t i = 0; i < model.group.size(); ++i)
    for (std::size_t k = 0; k < model.group.size(); ++k)
      if (model.group[i] == model.group[k])
        information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) += result.term;
  result.solver.compute(information);
  const Eigen::VectorXd pivots = result.solver.vectorD();
  result.is_regular = result.solver.info() == Eigen::Success && pivots.allFinite() &&
                      pivots.minCoeff() > least_share * pivots.maxCoeff();
  return result;
}

/// The worth of one stimulus as a linear function of the parameters: λ less the mean of its group.
Eigen::VectorXd contrast_of(const PairLikelihood& model, std::size_t stimulus) {
  Eigen::VectorXd contrast = Eigen::VectorXd::Zero(model.parameters);
  const std::size_t group = model.group[stimulus];
  for (std::size_t i = 0; i < model.group.size(); ++i)
    if (model.group[i] == group)
      contrast[static_cast<Eigen::Index>(i)] = -1.0 / static_cast<double>(model.sizes[group]);
  contrast[static_cast<Eigen::Index>(stimulus)] += 1.0;
  return contrast;
}

/// The step of Newton's method; if a contrast is held, within the parameters that leave it as it
/// is.
Eigen::VectorXd newton_step(const Completed& information, const Eigen::VectorXd& gradient,
                            const Eigen::VectorXd* held) {
  const Eigen::VectorXd step = information.solver.solve(gradient);
  if (held == nullptr) return step;
  const Eigen::VectorXd along = information.solver.solve(*held);
  return step - (held->dot(step) / held->dot(along)) * along;
}

/// The parameters at which the likelihood is greatest, nullopt if there are none; with `held`,
/// among those with the same value of that contrast as `start`. The log-likelihood is concave:
/// steps that would decrease it are halved.
std::optional<Eigen::VectorXd> maximum_of(const PairLikelihood& model, Eigen::VectorXd start,
                                          const Eigen::VectorXd* held = nullptr) {
  constexpr double bound = 1e-9;
  constexpr int most_steps = 100;
  Eigen::VectorXd at = std::move(start);
  double best = log_likelihood(model, at);
  for (int n = 0; n < most_steps; ++n) {
    const Derivatives slope = derivatives_of(model, at);
    const Completed information = completed(model, slope.information);
    if (!information.is_regular) return std::nullopt;
    Eigen::VectorXd step = newton_step(information, slope.gradient, held);
    if (!step.allFinite()) return std::nullopt;
    if (step.lpNorm<Eigen::Infinity>() < bound) return Eigen::VectorXd(at + step);
    double reached = log_likelihood(model, at + step);
    for (int halved = 0; halved < 40 && !(reached >= best - 1e-12 * std::abs(best)); ++halved) {
      step *= 0.5;
      reached = log_likelihood(model, at + step);
    }
    at += step;
    best = reached;
  }
  return std::nullopt;
}

Eigen::VectorXd parameters_of(const PairLikelihood& model, const BradleyTerry& fit) {
  Eigen::VectorXd at = Eigen::VectorXd::Zero(model.parameters);
  for (std::size_t i = 0; i < fit.worth.size(); ++i)
    if (fit.groups.records[i] == WinRecord::estimated)
      at[static_cast<Eigen::Index>(i)] = fit.worth[i];
  if (model.order >= 0) at[model.order] = fit.order;
  if (model.tie >= 0) at[model.tie] = fit.tie;
  return at;
}

BradleyTerry without_estimate(const WinGroups& groups) {
  const std::vector<double> none(groups.group.size(), no_worth);
  return {groups, false, none, none, no_worth, no_worth, no_worth, no_worth, no_worth};
}

void set_estimates(BradleyTerry& fit, const PairLikelihood& model, const Eigen::VectorXd& found,
                   const Completed& information) {
  const Eigen::MatrixXd covariance =
      information.solver.solve(Eigen::MatrixXd::Identity(model.parameters, model.parameters));
  const auto error_of = [&](Eigen::Index place) { return std::sqrt(covariance(place, place)); };
  fit.is_finite = true;
  fit.log_likelihood = log_likelihood(model, found);
  for (std::size_t i = 0; i < fit.worth.size(); ++i) {
    if (fit.groups.records[i] != WinRecord::estimated) continue;
    const auto place = static_cast<Eigen::Index>(i);
    const auto size = static_cast<double>(fit.groups.sizes[fit.groups.group[i]]);
    fit.worth[i] = found[place];
    // Less the variance that the added term gives to the sum of the group.
    fit.error[i] = std::sqrt(covariance(place, place) - 1.0 / (information.term * size * size));
  }
  if (model.order >= 0) {
    fit.order = found[model.order];
    fit.order_error = error_of(model.order);
  }
  if (model.tie >= 0) {
    fit.tie = found[model.tie];
    fit.tie_error = error_of(model.tie);
  }
}

/// One end of the profile interval: Newton's method on 2·(ℓ_max − ℓ(t)) − q, which is convex in the
/// fixed worth t, so that it converges from any start.
double profile_end(const PairLikelihood& model, const BradleyTerry& fit, std::size_t stimulus,
                   double side) {
  const double allowed = quantile(boost::math::chi_squared(1.0), 0.95);
  const Eigen::VectorXd contrast = contrast_of(model, stimulus);
  Eigen::VectorXd at = parameters_of(model, fit);
  double move = side * std::sqrt(allowed) * fit.error[stimulus];
  for (int n = 0; n < 50; ++n) {
    const Completed information = completed(model, derivatives_of(model, at).information);
    if (!information.is_regular) return no_worth;
    const Eigen::VectorXd along = information.solver.solve(contrast);
    const auto held = maximum_of(model, at + move / contrast.dot(along) * along, &contrast);
    if (!held) return no_worth;
    at = *held;
    if (std::abs(move) < 1e-9) return contrast.dot(at);
    // At this maximum the gradient is a multiple of the contrast.
    const double slope = contrast.dot(derivatives_of(model, at).gradient) / contrast.squaredNorm();
    move = (2.0 * (fit.log_likelihood - log_likelihood(model, at)) - allowed) / (2.0 * slope);
  }
  return no_worth;
}

LikelihoodRatio ratio_of(double chi, int degrees) {
  if (degrees < 1 || !std::isfinite(chi)) return {no_worth, degrees, no_worth};
  const double kept = std::max(0.0, chi);
  return {kept, degrees, cdf(complement(boost::math::chi_squared(degrees), kept))};
}

}  // namespace

BradleyTerry bradley_terry(const std::vector<PairCount>& counts, std::size_t stimuli,
                           OrderEffect order) {
  BradleyTerry fit = without_estimate(win_groups(counts, stimuli));
  if (stimuli == 0) return fit;
  const PairLikelihood model = likelihood_of(counts, fit.groups, order);
  const auto found = maximum_of(model, Eigen::VectorXd::Zero(model.parameters));
  if (!found) return fit;
  const Completed information = completed(model, derivatives_of(model, *found).information);
  if (information.is_regular) set_estimates(fit, model, *found, information);
  return fit;
}

std::vector<Interval95> profile_intervals(const BradleyTerry& fit,
                                          const std::vector<PairCount>& counts, OrderEffect order) {
  std::vector<Interval95> intervals(fit.worth.size(), {no_worth, no_worth});
  if (!fit.is_finite) return intervals;
  const PairLikelihood model = likelihood_of(counts, fit.groups, order);
  for (std::size_t i = 0; i < intervals.size(); ++i)
    if (fit.groups.records[i] == WinRecord::estimated)
      intervals[i] = {profile_end(model, fit, i, -1.0), profile_end(model, fit, i, 1.0)};
  return intervals;
}

std::vector<double> contrast_errors(const BradleyTerry& fit, const std::vector<PairCount>& counts,
                                    OrderEffect order,
                                    const std::vector<std::vector<double>>& contrasts) {
  std::vector<double> errors(contrasts.size(), no_worth);
  if (!fit.is_finite) return errors;
  const PairLikelihood model = likelihood_of(counts, fit.groups, order);
  const Completed information =
      completed(model, derivatives_of(model, parameters_of(model, fit)).information);
  if (!information.is_regular) return errors;
  for (std::size_t i = 0; i < contrasts.size(); ++i) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(model.parameters);
    for (std::size_t k = 0; k < contrasts[i].size(); ++k)
      weights[static_cast<Eigen::Index>(k)] = contrasts[i][k];
    errors[i] = std::sqrt(weights.dot(information.solver.solve(weights)));
  }
  return errors;
}

LikelihoodRatio equal_worth_test(const BradleyTerry& fit, const std::vector<PairCount>& counts,
                                 OrderEffect order) {
  const int degrees = fit.groups.compared - fit.groups.parts;
  if (!fit.is_finite) return {no_worth, degrees, no_worth};
  // Without differences in worth, all stimuli are the same: a single one.
  PairLikelihood model{{}, {0}, {1}};
  bool has_ties = false;
  for (const PairCount& count : counts) {
    if (count.first == count.second) continue;
    model.counts.push_back({0, 0, count.first_wins, count.second_wins, count.ties});
    has_ties = has_ties || count.ties > 0.0;
  }
  model.parameters = 1;
  if (order == OrderEffect::estimated) model.order = model.parameters++;
  if (has_ties) model.tie = model.parameters++;
  const auto found = maximum_of(model, Eigen::VectorXd::Zero(model.parameters));
  if (!found) return {no_worth, degrees, no_worth};
  return ratio_of(2.0 * (fit.log_likelihood - log_likelihood(model, *found)), degrees);
}

LikelihoodRatio order_test(const BradleyTerry& with_order, const BradleyTerry& without_order) {
  return ratio_of(2.0 * (with_order.log_likelihood - without_order.log_likelihood), 1);
}

}  // namespace mien::pipeline
