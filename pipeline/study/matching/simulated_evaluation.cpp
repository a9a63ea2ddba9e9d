#include "pipeline/study/matching/simulated_evaluation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pipeline/study/matching/target_sampling.h"

namespace mien::pipeline {

namespace {

/// A target, and how it was made.
struct TargetMotion {
  SampledTarget made_at;
  motion::Example motion;
  Eigen::VectorXd weights;
};

/// Targets are places of the first interface's parameters.
TargetMotion target_motion(const SampledTarget& target, const FittedInterface& interface,
                           const Interpolation& interpolation, const Repertoire& repertoire) {
  return {target, motion_of(interface, target.place, interpolation, repertoire),
          motion::weights_at(interface.interpolator, target.place).weights};
}

/// The interface that the target was made with makes it again at the very same place.
Eigen::RowVectorXd ideal_for(const TargetMotion& target, const FittedInterface& interface,
                             InterfaceKind target_kind, const Repertoire& repertoire) {
  if (interface.sliders.kind == target_kind) return target.made_at.place;
  return ideal_settings(interface.sliders, target.motion, target.weights, repertoire);
}

void simulate_target(const TargetMotion& target, const FittedInterface& interface,
                     const Eigen::RowVectorXd& ideal, const Interpolation& interpolation,
                     const Repertoire& repertoire, const EvaluationOptions& options,
                     std::vector<InterfaceResult>& results) {
  const std::string& id = target.made_at.id;
  const InterfaceKind kind = interface.sliders.kind;
  const SliderDistance distance_at = [&](const Eigen::RowVectorXd& settings) {
    return motion::distance(target.motion,
                            motion_of(interface, settings, interpolation, repertoire))
        .mean;
  };
  for (const double step : options.steps) {
    const double distance = distance_at(rounded(ideal, step));
    const bool matches = distance < options.threshold;
    results.push_back(
        {interpolation.weights.method, id, kind, step, 0, distance, distance, 1, matches, matches});
  }
  for (int u = 1; u <= options.users; ++u) {
    const SimulatedUser user = {.seed = options.seed,
                                .name = fmt::format("{} {} user {}", id, name_of(kind), u),
                                .threshold = options.threshold};
    const SimulatedTrial trial = simulate_trial(ideal, user, distance_at);
    results.push_back({interpolation.weights.method, id, kind, 0.0, u, trial.first_distance,
                       trial.distance, trial.views, trial.first_distance < options.threshold,
                       trial.matched});
  }
}

bool belongs_to(const InterfaceSummary& s, const InterfaceResult& r) {
  return s.method == r.method && s.kind == r.kind && s.step == r.step;
}

InterfaceSummary summary_of(const std::vector<InterfaceResult>& results,
                            const InterfaceResult& first) {
  InterfaceSummary s{first.method, first.kind, first.step};
  const auto belongs = [&](const InterfaceResult& r) { return belongs_to(s, r); };
  const auto n = static_cast<double>(std::count_if(results.begin(), results.end(), belongs));
  s.count = static_cast<int>(n);
  for (const InterfaceResult& r : results) {
    if (!belongs(r)) continue;
    s.mean_first += r.first_distance / n;
    s.mean_last += r.distance / n;
    s.mean_views += r.views / n;
    s.first_success += (r.first_matches ? 1.0 : 0.0) / n;
    s.failure += (r.matches ? 0.0 : 1.0) / n;
  }
  if (n < 2) return s;
  for (const InterfaceResult& r : results) {
    if (!belongs(r)) continue;
    s.sd_first += std::pow(r.first_distance - s.mean_first, 2) / (n - 1);
    s.sd_last += std::pow(r.distance - s.mean_last, 2) / (n - 1);
  }
  s.sd_first = std::sqrt(s.sd_first);
  s.sd_last = std::sqrt(s.sd_last);
  return s;
}

constexpr SharedColumn method_column{"method", "", "method of interpolation",
                                     [](auto& r) { return motion::name_of(r.method); }};
constexpr SharedColumn kind_column{"interface", "", "adjectives, features or weights",
                                   [](auto& r) { return name_of(r.kind); }};
constexpr SharedColumn procedure_column{
    "procedure", "",
    "nearest: the setting of a slider grid nearest to the target; user: a simulated user",
    [](auto& r) { return r.step > 0.0 ? "nearest" : "user"; }};
constexpr SharedColumn step_column{"step", "0–1", "step of the grid; empty for users",
                                   [](auto& r) { return r.step > 0.0 ? r.step : NAN; }};
constexpr SharedColumn nobody_column{"simulated", "", "always 1: no person is involved",
                                     [](auto&) { return true; }};

constexpr auto results_columns = table_of<InterfaceResult>(
    "interface_trials.csv", "target, interface and procedure",
    {method_column,
     {"target", "", "id of the target", [](auto& r) { return r.target; }},
     kind_column,
     procedure_column,
     step_column,
     {"user", "", "number of the simulated user, from 1",
      [](auto& r) { return r.user > 0 ? std::optional(r.user) : std::nullopt; }},
     {"first_d_m", "m", "D of the nearest setting of the grid, or of the first guess",
      [](auto& r) { return r.first_distance; }},
     {"d_m", "m", "D of the last setting", [](auto& r) { return r.distance; }},
     {"views", "", "number of motions viewed", [](auto& r) { return r.views; }},
     {"matched", "0/1", "1: D of the last setting is below the threshold",
      [](auto& r) { return r.matches; }},
     nobody_column});

constexpr auto summary_columns = table_of<InterfaceSummary>(
    "interface_summary.csv", "interface and procedure",
    {method_column,
     kind_column,
     procedure_column,
     step_column,
     {"count", "", "number of targets, or of trials of simulated users",
      [](auto& r) { return r.count; }},
     {"mean_first_d_m", "m", "mean of first_d_m in interface_trials.csv",
      [](auto& r) { return r.mean_first; }},
     {"sd_first_d_m", "m", "standard deviation of these (n − 1)",
      [](auto& r) { return r.sd_first; }},
     {"first_success", "0–1", "proportion with first_d_m below the threshold",
      [](auto& r) { return r.first_success; }},
     {"mean_d_m", "m", "mean of d_m in interface_trials.csv", [](auto& r) { return r.mean_last; }},
     {"sd_d_m", "m", "standard deviation of these (n − 1)", [](auto& r) { return r.sd_last; }},
     {"failure", "0–1", "proportion without a match", [](auto& r) { return r.failure; }},
     {"mean_views", "", "mean number of motions viewed", [](auto& r) { return r.mean_views; }},
     nobody_column});

}  // namespace

std::vector<SliderInterface> interfaces_of(const Repertoire& repertoire) {
  std::vector<SliderInterface> interfaces;
  if (!repertoire.parameters.names.empty())
    interfaces.push_back({InterfaceKind::adjectives, primary_adjectives(repertoire)});
  interfaces.push_back({InterfaceKind::features, primary_features()});
  std::vector<std::string> examples;
  for (const RatedExample& example : repertoire.names) examples.push_back(example.name);
  interfaces.push_back({InterfaceKind::weights, std::move(examples)});
  return interfaces;
}

std::vector<InterfaceResult> evaluate_interfaces(const Repertoire& repertoire,
                                                 const std::vector<SampledTarget>& targets,
                                                 const Interpolation& interpolation,
                                                 const EvaluationOptions& options) {
  const std::vector<SliderInterface> interfaces = interfaces_of(repertoire);
  std::vector<InterfaceResult> results;
  Interpolation how = interpolation;
  std::vector<motion::InterpolationMethod> methods = options.methods;
  if (methods.empty()) methods.push_back(interpolation.weights.method);
  for (const motion::InterpolationMethod method : methods) {
    how.weights.method = method;
    std::vector<FittedInterface> fitted;
    for (const SliderInterface& interface : interfaces)
      fitted.push_back(fit_interface(interface, how, repertoire));
    for (const SampledTarget& target : targets) {
      const TargetMotion known = target_motion(target, fitted.front(), how, repertoire);
      for (const FittedInterface& interface : fitted) {
        const Eigen::RowVectorXd ideal =
            ideal_for(known, interface, fitted.front().sliders.kind, repertoire);
        simulate_target(known, interface, ideal, how, repertoire, options, results);
      }
    }
  }
  return results;
}

std::vector<InterfaceSummary> summarise(const std::vector<InterfaceResult>& results) {
  std::vector<InterfaceSummary> summaries;
  for (const InterfaceResult& r : results) {
    const auto same = [&r](const InterfaceSummary& s) { return belongs_to(s, r); };
    if (std::any_of(summaries.begin(), summaries.end(), same)) continue;
    summaries.push_back(summary_of(results, r));
  }
  return summaries;
}

WrittenTable results_table(const std::vector<InterfaceResult>& results) {
  return results_columns.of(results);
}

WrittenTable summary_table(const std::vector<InterfaceSummary>& summaries) {
  return summary_columns.of(summaries);
}

}  // namespace mien::pipeline
