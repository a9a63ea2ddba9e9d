#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "pipeline/study/matching/matching_tables.h"

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
std::vector<Bar> grouped_bars(const MatchingEvaluation& evaluation, const auto& results,
                              const auto& make) {
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
  return {.title = "Distance of the first guess",
          .axis = "D, metres",
          .whiskers = "± 1 SD over participants",
          .bars = mean_bars(evaluation, MatchingMeasure::first_guess_d),
          .line = evaluation.threshold_m,
          .line_name = fmt::format("threshold {:g} m", evaluation.threshold_m),
          .decimals = 3,
          .simulated = simulated};
}

BarChart first_guess_success_chart(const MatchingEvaluation& evaluation, bool simulated) {
  return {.title = "First guesses that matched",
          .axis = fmt::format("proportion of guesses with D < {:g} m", evaluation.threshold_m),
          .bars = share_bars(evaluation, &MatchingShare::near_guesses, &MatchingShare::guesses),
          .percent = true,
          .simulated = simulated};
}

BarChart time_chart(const MatchingEvaluation& evaluation, bool simulated) {
  return {.title = "Time until the match",
          .axis = "seconds",
          .whiskers = "± 1 SD over participants",
          .bars = mean_bars(evaluation, MatchingMeasure::time_s),
          .simulated = simulated};
}

BarChart time_saved_chart(const MatchingEvaluation& evaluation, bool simulated) {
  return {.title = "Time saved",
          .axis = "seconds saved by the first-named interface (negative: lost)",
          .whiskers = "90 % interval of the mean",
          .bars = grouped_bars(evaluation, evaluation.comparisons,
                               [](const MatchingComparison& c) -> std::optional<Bar> {
                                 if (c.measure != MatchingMeasure::time_s) return std::nullopt;
                                 return Bar{.name = c.second,
                                            .value = c.difference.mean,
                                            .low = c.difference.low(0.9),
                                            .high = c.difference.high(0.9),
                                            .note = "vs. " + c.first,
                                            .second_note = fmt::format("n = {}", c.exact.pairs)};
                               }),
          .simulated = simulated};
}

BarChart failures_chart(const MatchingEvaluation& evaluation, bool simulated) {
  return {.title = "Trials without a match",
          .axis = "proportion of trials that reached the time limit",
          .bars = share_bars(evaluation, &MatchingShare::failures, &MatchingShare::trials),
          .percent = true,
          .simulated = simulated};
}

}  // namespace mien::pipeline
