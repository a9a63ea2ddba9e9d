#include "pipeline/base/adaptive/psychometric_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace mien::pipeline {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// How close to the limit of a constant or a step a maximum is treated as that limit.
constexpr double limit_tolerance = 1e-6;

double term(double count, double probability) {
  return count > 0.0 ? count * std::log(probability) : 0.0;
}

double outcome_log_likelihood(double positive, double negative, const AnswerProbability& p) {
  return term(positive, p.positive) + term(negative, p.negative);
}

/// a, b, γ, λ with ψ = γ + (1 − γ − λ) F(a + b·u) and u the level scaled to −1 … 1.
using Parameters = Eigen::Vector4d;

struct ScaledLevel {
  double u;
  double positive;
  double negative;
};

struct Slopes {
  Parameters gradient;
  Eigen::Matrix4d information;  ///< Fisher's
};

/// The likelihood of answers as a function of the parameters, and their bounds.
class Likelihood {
 public:
  Likelihood(const std::vector<LevelCount>& counts, const PsychometricModel& model)
      : centre(0.5 * (counts.front().level + counts.back().level)),
        scale(0.5 * (counts.back().level - counts.front().level)),
        least(-std::numeric_limits<double>::infinity(), 0.0, model.guess.least, model.lapse.least),
        most(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             model.guess.most, model.lapse.most),
        sigmoid_(model.sigmoid) {
    for (const LevelCount& count : counts)
      levels_.push_back({(count.level - centre) / scale, 1.0 * count.positive,
                         1.0 * count.trials - count.positive});
  }

  double at(const Parameters& p) const {
    double sum = 0.0;
    for (const ScaledLevel& level : levels_) {
      const SigmoidValue value = sigmoid_at(sigmoid_, p[0] + p[1] * level.u);
      const double range = 1.0 - p[2] - p[3];
      sum += outcome_log_likelihood(level.positive, level.negative,
                                    {p[2] + range * value.below, p[3] + range * value.above});
    }
    return sum;
  }

  Slopes slopes_at(const Parameters& p) const {
    Slopes slopes{Parameters::Zero(), Eigen::Matrix4d::Zero()};
    const double range = 1.0 - p[2] - p[3];
    for (const ScaledLevel& level : levels_) {
      const SigmoidValue value = sigmoid_at(sigmoid_, p[0] + p[1] * level.u);
      const double positive = p[2] + range * value.below;
      const double negative = p[3] + range * value.above;
      if (!(positive > 0.0 && negative > 0.0)) continue;
      const Parameters change(range * value.density, range * value.density * level.u, value.above,
                              -value.below);
      const double trials = level.positive + level.negative;
      slopes.gradient += (level.positive / positive - level.negative / negative) * change;
      slopes.information += trials / (positive * negative) * change * change.transpose();
    }
    return slopes;
  }

  double centre;
  double scale;
  Parameters least;
  Parameters most;

 private:
  Sigmoid sigmoid_;
  std::vector<ScaledLevel> levels_;
};

struct Optimum {
  Parameters parameters;
  double log_likelihood;
};

/// Parameters at a bound that the likelihood would leave do not move.
std::array<bool, 4> free_parameters(const Likelihood& likelihood, const Parameters& p,
                                    const Parameters& gradient) {
  std::array<bool, 4> free{};
  for (Eigen::Index i = 0; i < 4; ++i)
    free[static_cast<std::size_t>(i)] = likelihood.least[i] < likelihood.most[i] &&
                                        !(p[i] <= likelihood.least[i] && gradient[i] <= 0.0) &&
                                        !(p[i] >= likelihood.most[i] && gradient[i] >= 0.0);
  return free;
}

Parameters damped_step(Slopes slopes, const std::array<bool, 4>& free, double damping) {
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (!free[static_cast<std::size_t>(i)]) {
      slopes.gradient[i] = 0.0;
      slopes.information.row(i).setZero();
      slopes.information.col(i).setZero();
      slopes.information(i, i) = 1.0;
    } else {
      slopes.information(i, i) += damping * slopes.information(i, i) + 1e-12;
    }
  }
  return slopes.information.ldlt().solve(slopes.gradient);
}

Optimum climbed(const Likelihood& likelihood, Optimum best) {
  constexpr int most_steps = 500;
  constexpr double least_change = 1e-10;
  double damping = 1e-3;
  for (int n = 0; n < most_steps; ++n) {
    const Slopes slopes = likelihood.slopes_at(best.parameters);
    const auto free = free_parameters(likelihood, best.parameters, slopes.gradient);
    const Parameters next = (best.parameters + damped_step(slopes, free, damping))
                                .cwiseMax(likelihood.least)
                                .cwiseMin(likelihood.most);
    const double found = likelihood.at(next);
    const double change = (next - best.parameters)
                              .cwiseQuotient(Parameters::Ones() + best.parameters.cwiseAbs())
                              .cwiseAbs()
                              .maxCoeff();
    // Near the maximum differences are below the precision of the sum.
    const bool is_better = found >= best.log_likelihood - 1e-14 * std::abs(best.log_likelihood);
    if (is_better) best = {next, std::max(found, best.log_likelihood)};
    if (change < least_change) break;
    damping = is_better ? 0.1 * damping : 10.0 * damping;
    if (damping > 1e12) break;
  }
  return best;
}

std::vector<double> rate_starts(double least, double most) {
  if (least >= most) return {least};
  return {least + 0.1 * (most - least), least + 0.6 * (most - least)};
}

std::vector<Optimum> starts_of(const Likelihood& likelihood) {
  std::vector<Optimum> starts;
  for (const double guess : rate_starts(likelihood.least[2], likelihood.most[2]))
    for (const double lapse : rate_starts(likelihood.least[3], likelihood.most[3]))
      for (const double location : {-1.0, -0.5, 0.0, 0.5, 1.0})
        for (const double width : {0.08, 0.25, 0.8, 2.5}) {
          const Parameters p(-location / width, 1.0 / width, guess, lapse);
          starts.push_back({p, likelihood.at(p)});
        }
  std::ranges::stable_sort(starts, std::ranges::greater{}, &Optimum::log_likelihood);
  return starts;
}

Optimum maximum_of(const Likelihood& likelihood) {
  constexpr std::size_t climbs = 4;
  const std::vector<Optimum> starts = starts_of(likelihood);
  Optimum best = climbed(likelihood, starts.front());
  for (std::size_t i = 1; i < climbs; ++i) {
    const Optimum other = climbed(likelihood, starts[i]);
    if (other.log_likelihood > best.log_likelihood) best = other;
  }
  return best;
}

/// The part of the log-likelihood of all levels of a range, with the same probability for each.
struct ConstantPart {
  double positive = 0.0;
  double negative = 0.0;

  /// The most likely probability within bounds; `otherwise` without trials.
  double probability(double least, double most, double otherwise) const {
    const double trials = positive + negative;
    return trials > 0.0 ? std::clamp(positive / trials, least, most) : otherwise;
  }

  double log_likelihood(double p) const {
    return outcome_log_likelihood(positive, negative, {p, 1.0 - p});
  }
};

ConstantPart part_of(const std::vector<LevelCount>& counts, std::size_t from, std::size_t to) {
  ConstantPart part;
  for (std::size_t i = from; i < to; ++i) {
    part.positive += counts[i].positive;
    part.negative += counts[i].trials - counts[i].positive;
  }
  return part;
}

/// A limit of functions with width 0.
struct Step {
  double log_likelihood = -std::numeric_limits<double>::infinity();
  IntervalEnds ends = {not_a_number, not_a_number};
};

/// The best step, between levels or at one of them, at which any proportion is possible.
Step best_step(const std::vector<LevelCount>& counts, const PsychometricModel& model) {
  Step best;
  const double highest = 1.0 - model.lapse.least;
  const auto consider = [&](std::size_t first, std::size_t last, IntervalEnds ends) {
    const ConstantPart below = part_of(counts, 0, first);
    const ConstantPart at = part_of(counts, first, last);
    const ConstantPart above = part_of(counts, last, counts.size());
    const double low = below.probability(model.guess.least, model.guess.most, model.guess.least);
    const double high = above.probability(1.0 - model.lapse.most, highest, highest);
    const double found = below.log_likelihood(low) + above.log_likelihood(high) +
                         at.log_likelihood(at.probability(low, high, low));
    if (found > best.log_likelihood) best = {found, ends};
  };
  for (std::size_t i = 1; i < counts.size(); ++i)
    consider(i, i, {counts[i - 1].level, counts[i].level});
  for (std::size_t i = 0; i < counts.size(); ++i)
    consider(i, i + 1, {counts[i].level, counts[i].level});
  return best;
}

double observed_log_likelihood(const std::vector<LevelCount>& counts) {
  double sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const ConstantPart part = part_of(counts, i, i + 1);
    sum += part.log_likelihood(part.probability(0.0, 1.0, 0.0));
  }
  return sum;
}

FitProblem problem_of_counts(const std::vector<LevelCount>& counts,
                             const PsychometricModel& model) {
  if (counts.empty()) return FitProblem::no_trials;
  const ConstantPart all = part_of(counts, 0, counts.size());
  if (all.positive <= 0.0) return FitProblem::all_negative;
  if (all.negative <= 0.0) return FitProblem::all_positive;
  const std::size_t parameters =
      2u + (model.guess.is_estimated() ? 1u : 0u) + (model.lapse.is_estimated() ? 1u : 0u);
  return counts.size() < parameters ? FitProblem::too_few_levels : FitProblem::none;
}

double fixed_or_unknown(const RateRange& rate) {
  return rate.is_estimated() ? not_a_number : rate.least;
}

}  // namespace

std::vector<LevelCount> pooled_levels(std::vector<LevelCount> counts) {
  std::erase_if(counts, [](const LevelCount& count) { return count.trials == 0; });
  std::ranges::sort(counts, {}, &LevelCount::level);
  std::vector<LevelCount> pooled;
  for (const LevelCount& count : counts) {
    if (pooled.empty() || pooled.back().level < count.level) pooled.push_back({count.level, 0, 0});
    pooled.back().trials += count.trials;
    pooled.back().positive += count.positive;
  }
  return pooled;
}

PsychometricFit psychometric_fit(const std::vector<LevelCount>& all_counts,
                                 const PsychometricModel& model) {
  const std::vector<LevelCount> counts = pooled_levels(all_counts);
  PsychometricFit fit;
  fit.step = {not_a_number, not_a_number};
  fit.function = {model.sigmoid, not_a_number, not_a_number, fixed_or_unknown(model.guess),
                  fixed_or_unknown(model.lapse)};
  fit.problem = problem_of_counts(counts, model);
  if (fit.problem == FitProblem::no_trials) return fit;
  const ConstantPart all = part_of(counts, 0, counts.size());
  const double flat = all.log_likelihood(
      all.probability(model.guess.least, 1.0 - model.lapse.least, model.guess.least));
  const Step step = best_step(counts, model);
  fit.log_likelihood = std::max(flat, step.log_likelihood);
  if (counts.size() > 1) {
    const Likelihood likelihood(counts, model);
    const auto [found, log_likelihood] = maximum_of(likelihood);
    if (fit.problem == FitProblem::none) {
      if (flat >= log_likelihood - limit_tolerance)
        fit.problem = FitProblem::not_rising;
      else if (step.log_likelihood >= log_likelihood - limit_tolerance)
        fit.problem = FitProblem::step;
    }
    if (fit.problem == FitProblem::none)
      fit.function = {model.sigmoid, likelihood.centre - likelihood.scale * found[0] / found[1],
                      likelihood.scale / found[1], found[2], found[3]};
    fit.log_likelihood = std::max(fit.log_likelihood, log_likelihood);
  }
  if (fit.problem == FitProblem::step) fit.step = step.ends;
  fit.deviance = std::max(0.0, 2.0 * (observed_log_likelihood(counts) - fit.log_likelihood));
  return fit;
}

}  // namespace mien::pipeline
