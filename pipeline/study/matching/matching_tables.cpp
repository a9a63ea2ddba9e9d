#include "pipeline/study/matching/matching_tables.h"

#include <cmath>
#include <ranges>

#include "pipeline/base/documents/p_value.h"
#include "pipeline/base/documents/written_tables.h"

namespace mien::pipeline {

namespace {

using MeanRow = GivenOrSimulated<MatchingMean>;
using ShareRow = GivenOrSimulated<MatchingShare>;
using ComparedRow = GivenOrSimulated<MatchingComparison>;

double share(int part, int all) { return all > 0 ? part / static_cast<double>(all) : NAN; }

constexpr SharedColumn measure_column = {"measure", "", "first_guess_d (metres) or time_s",
                                         [](auto& r) { return name_of(r.of.measure); }};
constexpr SharedColumn interface_column = {"interface", "", "adjectives, features, weights …",
                                           [](auto& r) { return r.of.interface; }};
constexpr SharedColumn first_column = {"first", "", "an interface",
                                       [](auto& r) { return r.of.first; }};
constexpr SharedColumn second_column = {"second", "", "the one that is taken from it",
                                        [](auto& r) { return r.of.second; }};
constexpr SharedColumn pairs_column = {"participants", "", "participants",
                                       [](auto& r) { return r.of.exact.pairs; }};
constexpr SharedColumn target_column = {
    "target", "", "the target; all: over the means of participants",
    [](auto& r) { return r.of.target.empty() ? "all" : r.of.target; }};
constexpr SharedColumn sessions_column = {"sessions", "", "given (by people) or simulated",
                                          [](auto& r) { return given_or_simulated(r.simulated); }};

constexpr auto means_columns = table_of<MeanRow>(
    "means.csv", "a measure, interface and target",
    {measure_column,
     interface_column,
     target_column,
     sessions_column,
     {"n", "", "values", [](auto& r) { return r.of.n; }},
     {"mean", "m or s", "mean of those answers", [](auto& r) { return r.of.mean; }},
     {"sd", "m or s", "their standard deviation, n − 1", [](auto& r) { return r.of.sd; }}});

constexpr auto shares_columns = table_of<ShareRow>(
    "shares.csv", "an interface and target",
    {interface_column,
     target_column,
     sessions_column,
     {"guesses", "", "blind guesses", [](auto& r) { return r.of.guesses; }},
     {"near_guesses", "", "of these with D below the threshold",
      [](auto& r) { return r.of.near_guesses; }},
     {"near_share", "0–1", "proportion of identical answers",
      [](auto& r) { return share(r.of.near_guesses, r.of.guesses); }},
     {"trials", "", "trials", [](auto& r) { return r.of.trials; }},
     {"failures", "", "of these without a match", [](auto& r) { return r.of.failures; }},
     {"failure_share", "0–1", "proportion of identical answers",
      [](auto& r) { return share(r.of.failures, r.of.trials); }}});

constexpr auto time_saved_columns = table_of<ComparedRow>(
    "time_saved.csv", "a pair of interfaces and target",
    {first_column,
     second_column,
     target_column,
     sessions_column,
     pairs_column,
     {"saved_s", "s", "what the second saves: mean of first less second",
      [](auto& r) { return r.of.difference.mean; }},
     {"low_90", "s", "lower end of its 90 % interval; empty where all are identical",
      [](auto& r) { return r.of.difference.low(0.9); }},
     {"high_90", "s", "upper end of that interval",
      [](auto& r) { return r.of.difference.high(0.9); }}});

constexpr auto compared_columns = table_of<ComparedRow>(
    "comparisons.csv", "a measure, pair of interfaces and target",
    {measure_column,
     first_column,
     second_column,
     target_column,
     sessions_column,
     pairs_column,
     {"mean_difference", "m or s", "mean of first less second",
      [](auto& r) { return r.of.difference.mean; }},
     {"w_plus", "", "Wilcoxon: sum of the ranks above 0",
      [](auto& r) { return r.of.exact.w_plus; }},
     {"w_minus", "", "sum of the ranks below 0", [](auto& r) { return r.of.exact.w_minus; }},
     {"p_paper", "", "normal approximation without continuity correction, as published",
      [](auto& r) { return p_of_table(r.of.paper.p); }},
     {"p_paper_holm", "", "corrected (Holm) within a measure",
      [](auto& r) { return p_of_table(r.of.paper_holm); }},
     {"p_exact", "", "exact, two-sided", [](auto& r) { return p_of_table(r.of.exact.p); }},
     {"p_exact_holm", "", "corrected (Holm) within a measure",
      [](auto& r) { return p_of_table(r.of.exact_holm); }},
     {"rank_biserial", "-1–1", "matched-pairs rank-biserial correlation",
      [](auto& r) { return r.of.exact.rank_biserial; }},
     {"d_z", "", "mean difference in units of its SD", [](auto& r) { return r.of.d_z; }},
     {"t", "", "paired t", [](auto& r) { return r.of.difference.t; }},
     {"p_t", "", "its two-sided p", [](auto& r) { return p_of_table(r.of.difference.p); }}});

}  // namespace

void write_evaluation(const MatchingEvaluation& evaluation, const MatchingResults& results,
                      const std::filesystem::path& folder) {
  const bool simulated = results.simulated;
  const auto is_time = [](const MatchingComparison& c) {
    return c.measure == MatchingMeasure::time_s;
  };
  const auto times = evaluation.comparisons | std::views::filter(is_time);
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
