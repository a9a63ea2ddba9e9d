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

/// What the sliders are set to, and a motion that has it.
struct TriedSetting {
  Eigen::RowVectorXd values;
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
struct MethodFit {
  const FittedInterface& sliders;
  const Eigen::MatrixXd& places;

  Eigen::VectorXd weights(const Eigen::RowVectorXd& settings) const {
    return motion::weights_at(sliders.interpolator, settings).weights;
  }
};

void add_errors(const MethodFit& fit, const std::vector<TriedSetting>& tried,
                MethodResult& result) {
  const auto count = static_cast<double>(tried.size());
  const auto begun = std::chrono::steady_clock::now();
  for (const TriedSetting& setting : tried) {
    const Eigen::VectorXd weights = fit.weights(setting.values);
    const double error =
        (weights.transpose() * fit.places - setting.values).lpNorm<Eigen::Infinity>();
    result.mean_error += error / count;
    result.worst_error = std::max(result.worst_error, error);
    result.mean_examples += motion::effective_examples(weights) / count;
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun;
  result.seconds = spent.count() / count;
}

double largest_jump(const MethodFit& fit, const std::vector<TriedSetting>& tried, int steps) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < tried.size(); ++i) {
    Eigen::VectorXd last = fit.weights(tried[i].values);
    for (int step = 1; step <= steps; ++step) {
      const double share = static_cast<double>(step) / steps;
      const Eigen::VectorXd now =
          fit.weights((1.0 - share) * tried[i].values + share * tried[i + 1].values);
      largest = std::max(largest, (now - last).lpNorm<Eigen::Infinity>());
      last = now;
    }
  }
  return largest;
}

constexpr auto method_columns = table_of<WithOrigin<MethodResult>>(
    "methods.csv", "method of interpolation",
    {{"method", "", "the method", [](auto& r) { return motion::name_of(r.of.method); }},
     {"settings", "", "number of slider settings tried", [](auto& r) { return r.of.settings; }},
     {"mean_error", "0–1",
      "mean over the settings of the largest |reached − requested| of a parameter",
      [](auto& r) { return shortest_measured(r.of.mean_error); }},
     {"worst_error", "0–1", "largest of these errors",
      [](auto& r) { return shortest_measured(r.of.worst_error); }},
     {"jump", "0–1", "largest change of a weight in one step between settings",
      [](auto& r) { return shortest_measured(r.of.jump); }},
     {"mean_examples", "", "mean effective number of examples, 1 / Σ w²",
      [](auto& r) { return r.of.mean_examples; }},
     {"mean_d_m", "m", "mean D to the motion that has the parameters requested",
      [](auto& r) { return r.of.mean_distance; }},
     whose_ratings_column});

}  // namespace

std::vector<MethodResult> compare_methods(const Repertoire& repertoire,
                                          const std::vector<std::string>& parameters,
                                          const std::vector<motion::InterpolationMethod>& methods,
                                          const Interpolation& interpolation,
                                          const MethodComparisonOptions& options) {
  const Eigen::MatrixXd places = places_of_examples(parameters, repertoire.parameters);
  const motion::ExampleSet& examples = examples_for(interpolation, repertoire);
  const motion::BlendOptions as_blends{.rotations = interpolation.rotations,
                                       .warp = interpolation.time_warp};
  std::vector<TriedSetting> tried;
  for (int draw = 0; draw < options.settings; ++draw) {
    const Eigen::VectorXd weights = drawn_blend(options.seed, draw, places.rows());
    tried.push_back({weights.transpose() * places, motion::blend(examples, weights, as_blends)});
  }
  std::vector<MethodResult> results;
  for (const motion::InterpolationMethod method : methods) {
    Interpolation how = interpolation;
    how.weights.method = method;
    const FittedInterface sliders =
        fit_interface({InterfaceKind::adjectives, parameters}, how, repertoire);
    const MethodFit fit{sliders, places};
    MethodResult result{.method = method, .settings = options.settings};
    add_errors(fit, tried, result);
    result.jump = largest_jump(fit, tried, options.steps);
    for (const TriedSetting& setting : tried) {
      const motion::Example made = motion_of(sliders, setting.values, how, repertoire);
      result.mean_distance += motion::distance(setting.motion, made).mean / options.settings;
    }
    results.push_back(result);
  }
  return results;
}

WrittenTable method_results_table(const std::vector<MethodResult>& trials, bool simulated_ratings) {
  return method_columns.of_parts(simulated_ratings, trials);
}

}  // namespace mien::pipeline
