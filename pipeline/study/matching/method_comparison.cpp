#include "pipeline/study/matching/method_comparison.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "motion/interpolation/blend.h"
#include "motion/interpolation/reach.h"
#include "motion/measures/distance/distance.h"
#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

namespace {

/// Target parameters, and a blend that has them.
struct TrialWish {
  Eigen::RowVectorXd settings;
  motion::Example motion;
};

/// Random weights of three independently drawn examples.
Eigen::VectorXd drawn_blend(std::uint64_t seed, int draw, Eigen::Index count) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (int part = 0; part < 3; ++part) {
    const double place = uniform(seed, fmt::format("wish {} example {}", draw, part));
    const auto i = std::min<Eigen::Index>(
        count - 1, static_cast<Eigen::Index>(place * static_cast<double>(count)));
    weights[i] += uniform(seed, fmt::format("wish {} share {}", draw, part));
  }
  return weights / weights.sum();
}

/// A method with its fitted weights, and the parameters of its examples.
struct Trial {
  const FittedInterface& sliders;
  const Eigen::MatrixXd& places;

  Eigen::VectorXd weights(const Eigen::RowVectorXd& settings) const {
    return motion::weights_at(sliders.interpolator, settings).weights;
  }
};

void add_errors(const Trial& trial, const std::vector<TrialWish>& wishes, MethodTrial& result) {
  const auto count = static_cast<double>(wishes.size());
  const auto begun = std::chrono::steady_clock::now();
  for (const TrialWish& wish : wishes) {
    const Eigen::VectorXd weights = trial.weights(wish.settings);
    const double error =
        (weights.transpose() * trial.places - wish.settings).lpNorm<Eigen::Infinity>();
    result.mean_error += error / count;
    result.worst_error = std::max(result.worst_error, error);
    result.mean_examples += motion::effective_examples(weights) / count;
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun;
  result.seconds = spent.count() / count;
}

double largest_jump(const Trial& trial, const std::vector<TrialWish>& wishes, int steps) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < wishes.size(); ++i) {
    Eigen::VectorXd last = trial.weights(wishes[i].settings);
    for (int step = 1; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const Eigen::VectorXd now =
          trial.weights((1.0 - share) * wishes[i].settings + share * wishes[i + 1].settings);
      largest = std::max(largest, (now - last).lpNorm<Eigen::Infinity>());
      last = now;
    }
  }
  return largest;
}

constexpr auto method_columns = table_of<GivenOrSimulated<MethodTrial>>(
    "methods.csv", "method of interpolation",
    {{"method", "", "the method", [](auto& r) { return motion::name_of(r.of.method); }},
     {"wishes", "", "settings of the sliders that were tried", [](auto& r) { return r.of.wishes; }},
     {"mean_error", "0–1", "mean of the largest |reached − target| over parameters",
      [](auto& r) { return shortest_measured(r.of.mean_error); }},
     {"worst_error", "0–1", "the largest of these",
      [](auto& r) { return shortest_measured(r.of.worst_error); }},
     {"jump", "0–1", "largest change of a weight in one step between settings",
      [](auto& r) { return shortest_measured(r.of.jump); }},
     {"mean_examples", "", "effective number of examples, 1 / Σ w²",
      [](auto& r) { return r.of.mean_examples; }},
     {"mean_d_m", "m", "D to the blend that has the target parameters",
      [](auto& r) { return r.of.mean_distance; }},
     whose_ratings_column});

}  // namespace

std::vector<MethodTrial> compare_methods(const Repertoire& repertoire,
                                         const std::vector<std::string>& parameters,
                                         const std::vector<motion::InterpolationMethod>& methods,
                                         const Interpolation& interpolation,
                                         const MethodTrialOptions& options) {
  const Eigen::MatrixXd places = places_of_examples(parameters, repertoire.parameters);
  const motion::ExampleSet& examples = examples_for(interpolation, repertoire);
  const motion::BlendOptions as_blends{.rotations = interpolation.rotations,
                                       .warp = interpolation.time_warp};
  std::vector<TrialWish> wishes;
  for (int draw = 0; draw < options.wishes; ++draw) {
    const Eigen::VectorXd weights = drawn_blend(options.seed, draw, places.rows());
    wishes.push_back({weights.transpose() * places, motion::blend(examples, weights, as_blends)});
  }
  std::vector<MethodTrial> results;
  for (const motion::InterpolationMethod method : methods) {
    Interpolation how = interpolation;
    how.weights.method = method;
    const FittedInterface sliders =
        fit_interface({InterfaceKind::adjectives, parameters}, how, repertoire);
    const Trial trial{sliders, places};
    MethodTrial result{.method = method, .wishes = options.wishes};
    add_errors(trial, wishes, result);
    result.jump = largest_jump(trial, wishes, options.steps);
    for (const TrialWish& wish : wishes) {
      const motion::Example made = motion_of(sliders, wish.settings, how, repertoire);
      result.mean_distance += motion::distance(wish.motion, made).mean / options.wishes;
    }
    results.push_back(result);
  }
  return results;
}

WrittenTable method_trials_table(const std::vector<MethodTrial>& trials, bool simulated_ratings) {
  return method_columns.of_parts(simulated_ratings, trials);
}

}  // namespace mien::pipeline
