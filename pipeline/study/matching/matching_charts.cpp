#include "pipeline/study/matching/matching_charts.h"

#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// More targets than these are in the tables alone: nobody could read the bars.
constexpr std::size_t most_targets = 12;

/// The targets, one after the other, then all.
std::vector<std::string> groups_of(const MatchingEvaluation& evaluation) {
  std::vector<std::string> groups;
  if (evaluation.targets.size() <= most_targets) groups = evaluation.targets;
  groups.emplace_back();
  return groups;
}

std::string group_name(const MatchingEvaluation& evaluation, const std::string& target) {
  if (evaluation.targets.empty()) return "";
  return target.empty() ? "all targets" : target;
}

/// For each group the bars that `bar` makes of what belongs to its target.
template <class Results, class Make>
std::vector<Bar> grouped_bars(const MatchingEvaluation& evaluation, const Results& results,
                              const Make& make) {
  std::vector<Bar> bars;
  for (const std::string& target : groups_of(evaluation)) {
    for (const auto& result : results) {
      if (result.target != target) continue;
      std::optional<Bar> bar = make(result);
      if (!bar) continue;
      bar->group = group_name(evaluation, target);
      bars.push_back(*std::move(bar));
    }
  }
  return bars;
}

std::vector<Bar> mean_bars(const MatchingEvaluation& evaluation, MatchingMeasure measure) {
  return grouped_bars(evaluation, evaluation.means,
                      [&](const MatchingMean& m) -> std::optional<Bar> {
                        if (m.measure != measure) return std::nullopt;
                        return Bar{.name = m.interface,
                                   .value = m.mean,
                                   .low = m.mean - m.sd,
                                   .high = m.mean + m.sd,
                                   .note = fmt::format("n = {}", m.n)};
                      });
}

std::vector<Bar> share_bars(const MatchingEvaluation& evaluation, int MatchingShare::*part,
                            int MatchingShare::*all) {
  return grouped_bars(evaluation, evaluation.shares,
                      [&](const MatchingShare& s) -> std::optional<Bar> {
                        if (s.*all == 0) return std::nullopt;
                        return Bar{.name = s.interface,
                                   .value = s.*part / static_cast<double>(s.*all),
                                   .low = none,
                                   .high = none,
                                   .note = fmt::format("{} of {}", s.*part, s.*all)};
                      });
}

}  // namespace

BarChart first_guess_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Distance of the first guess";
  chart.axis = "D, metres";
  chart.whiskers = "± 1 SD over participants";
  chart.bars = mean_bars(evaluation, MatchingMeasure::first_guess_d);
  chart.line = evaluation.threshold_m;
  chart.line_name = fmt::format("threshold {:g} m", evaluation.threshold_m);
  chart.decimals = 3;
  chart.simulated = simulated;
  return chart;
}

BarChart first_guess_success_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "First guesses that matched";
  chart.axis = fmt::format("share of guesses with D < {:g} m", evaluation.threshold_m);
  chart.bars = share_bars(evaluation, &MatchingShare::near_guesses, &MatchingShare::guesses);
  chart.percent = true;
  chart.simulated = simulated;
  return chart;
}

BarChart time_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Time until the match";
  chart.axis = "seconds";
  chart.whiskers = "± 1 SD over participants";
  chart.bars = mean_bars(evaluation, MatchingMeasure::time_s);
  chart.simulated = simulated;
  return chart;
}

BarChart time_saved_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Time saved";
  chart.axis = "seconds that the first-named interface saves (below 0: that it costs)";
  chart.whiskers = "90 % interval of the mean";
  chart.bars = grouped_bars(evaluation, evaluation.comparisons,
                            [](const MatchingComparison& c) -> std::optional<Bar> {
                              if (c.measure != MatchingMeasure::time_s) return std::nullopt;
                              return Bar{.name = c.second,
                                         .value = c.difference.mean,
                                         .low = c.difference.low(0.9),
                                         .high = c.difference.high(0.9),
                                         .note = "against " + c.first,
                                         .second_note = fmt::format("n = {}", c.exact.pairs)};
                            });
  chart.simulated = simulated;
  return chart;
}

BarChart failures_chart(const MatchingEvaluation& evaluation, bool simulated) {
  BarChart chart;
  chart.title = "Trials without a match";
  chart.axis = "share of trials that reached the time limit";
  chart.bars = share_bars(evaluation, &MatchingShare::failures, &MatchingShare::trials);
  chart.percent = true;
  chart.simulated = simulated;
  return chart;
}

}  // namespace mien::pipeline
