#include "pipeline/study/matching/matching_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// With more targets, charts would be unreadable; they are in the tables only.
constexpr std::size_t max_targets = 12;

/// The targets, one after the other, then all.
std::vector<std::string> groups_of(const MatchingEvaluation& evaluation) {
  std::vector<std::string> groups;
  if (evaluation.targets.size() <= max_targets) groups = evaluation.targets;
  groups.emplace_back();
  return groups;
}

std::string group_name(const MatchingEvaluation& evaluation, const std::string& target) {
  if (evaluation.targets.empty()) return "";
  return target.empty() ? "all targets" : target;
}

/// For each group, the bars that `bar` makes of the results of its target.
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

using MeanRow = WithOrigin<MatchingMean>;
using ShareRow = WithOrigin<MatchingShare>;
using ComparedRow = WithOrigin<MatchingComparison>;

double share(int part, int all) { return all > 0 ? part / static_cast<double>(all) : NAN; }

constexpr SharedColumn measure_column{"measure", "", "first_guess_d (metres) or time_s",
                                      [](auto& r) { return name_of(r.of.measure); }};
constexpr SharedColumn interface_column{"interface", "", "adjectives, features, weights …",
                                        [](auto& r) { return r.of.interface; }};
constexpr SharedColumn first_column{"first", "", "one interface",
                                    [](auto& r) { return r.of.first; }};
constexpr SharedColumn second_column{"second", "", "the interface subtracted from it",
                                     [](auto& r) { return r.of.second; }};
constexpr SharedColumn pairs_column{"participants", "",
                                    "number of participants with both interfaces",
                                    [](auto& r) { return r.of.exact.pairs; }};
constexpr SharedColumn target_column{
    "target", "", "id of the target; all: all targets together",
    [](auto& r) { return r.of.target.empty() ? "all" : r.of.target; }};
constexpr SharedColumn sessions_column{"sessions", "", "given (by people) or simulated",
                                       [](auto& r) { return origin_text(r.simulated); }};

constexpr auto means_columns = table_of<MeanRow>(
    "means.csv", "measure, interface and target",
    {measure_column,
     interface_column,
     target_column,
     sessions_column,
     {"n", "", "number of values: trials of the target, or participants for all",
      [](auto& r) { return r.of.n; }},
     {"mean", "m or s", "mean of these values", [](auto& r) { return r.of.mean; }},
     {"sd", "m or s", "standard deviation of these values (n − 1)",
      [](auto& r) { return r.of.sd; }}});

constexpr auto shares_columns = table_of<ShareRow>(
    "shares.csv", "interface and target",
    {interface_column,
     target_column,
     sessions_column,
     {"guesses", "", "number of trials with a first guess", [](auto& r) { return r.of.guesses; }},
     {"near_guesses", "", "first guesses with D below the threshold",
      [](auto& r) { return r.of.near_guesses; }},
     {"near_share", "0–1", "proportion of first guesses with D below the threshold",
      [](auto& r) { return share(r.of.near_guesses, r.of.guesses); }},
     {"trials", "", "number of trials", [](auto& r) { return r.of.trials; }},
     {"failures", "", "trials without a match within the time limit",
      [](auto& r) { return r.of.failures; }},
     {"failure_share", "0–1", "proportion of trials without a match",
      [](auto& r) { return share(r.of.failures, r.of.trials); }}});

constexpr auto time_saved_columns = table_of<ComparedRow>(
    "time_saved.csv", "pair of interfaces and target",
    {first_column,
     second_column,
     target_column,
     sessions_column,
     pairs_column,
     {"saved_s", "s",
      "time saved by the second interface: mean over participants of first minus second",
      [](auto& r) { return r.of.difference.mean; }},
     {"low_90", "s", "lower end of its 90 % interval; empty if all differences are equal",
      [](auto& r) { return r.of.difference.low(0.9); }},
     {"high_90", "s", "upper end of that interval",
      [](auto& r) { return r.of.difference.high(0.9); }}});

constexpr auto compared_columns = table_of<ComparedRow>(
    "comparisons.csv", "measure, pair of interfaces and target",
    {measure_column,
     first_column,
     second_column,
     target_column,
     sessions_column,
     pairs_column,
     {"mean_difference", "m or s", "mean over participants of first minus second",
      [](auto& r) { return r.of.difference.mean; }},
     {"w_plus", "", "Wilcoxon: sum of the ranks of positive differences",
      [](auto& r) { return r.of.exact.w_plus; }},
     {"w_minus", "", "sum of the ranks of negative differences",
      [](auto& r) { return r.of.exact.w_minus; }},
     {"p_paper", "",
      "Wilcoxon, two-sided: normal approximation without continuity correction, as published",
      [](auto& r) { return p_field(r.of.paper.p); }},
     {"p_paper_holm", "",
      "p corrected (Holm) over the comparisons of the measure: those over all targets, or those of "
      "single targets",
      [](auto& r) { return p_field(r.of.normal_holm); }},
     {"p_exact", "", "Wilcoxon, two-sided: exact", [](auto& r) { return p_field(r.of.exact.p); }},
     {"p_exact_holm", "",
      "p corrected (Holm) over the comparisons of the measure: those over all targets, or those of "
      "single targets",
      [](auto& r) { return p_field(r.of.exact_holm); }},
     {"rank_biserial", "-1–1", "matched-pairs rank-biserial correlation",
      [](auto& r) { return r.of.exact.rank_biserial; }},
     {"d_z", "", "mean difference divided by the standard deviation of the differences",
      [](auto& r) { return r.of.d_z; }},
     {"t", "", "paired t; empty if all differences are equal",
      [](auto& r) { return r.of.difference.t; }},
     {"p_t", "", "its two-sided p", [](auto& r) { return p_field(r.of.difference.p); }}});

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

void write_evaluation(const MatchingEvaluation& evaluation, const MatchingResults& results,
                      const std::filesystem::path& folder) {
  const bool simulated = results.simulated;
  const auto is_time = [](const MatchingComparison& c) {
    return c.measure == MatchingMeasure::time_s;
  };
  std::vector<MatchingComparison> times;
  std::ranges::copy_if(evaluation.comparisons, std::back_inserter(times), is_time);
  write_tables(folder, {means_columns.of_parts(simulated, evaluation.means),
                        shares_columns.of_parts(simulated, evaluation.shares),
                        time_saved_columns.of_parts(simulated, times),
                        compared_columns.of_parts(simulated, evaluation.comparisons)});
  const auto draw = [&](const char* name, const BarChart& chart) {
    write_plot(bar_chart_plot(chart), folder, name);
  };
  draw("first_guess_d", first_guess_chart(evaluation, simulated));
  draw("first_guess_success", first_guess_success_chart(evaluation, simulated));
  draw("time", time_chart(evaluation, simulated));
  draw("time_saved", time_saved_chart(evaluation, simulated));
  draw("failures", failures_chart(evaluation, simulated));
}

}  // namespace mien::pipeline
