#include "pipeline/study/matching/matching_tables.h"

#include <cmath>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/p_value.h"
#include "pipeline/study/matching/matching_charts.h"

namespace mien::pipeline {

namespace {

std::string sessions(bool simulated) { return simulated ? "simulated" : "given"; }

std::string number(double value) { return std::isfinite(value) ? shortest(value) : ""; }

std::string target_name(const std::string& target) { return target.empty() ? "all" : target; }

std::string share(int part, int all) {
  return all > 0 ? shortest(part / static_cast<double>(all)) : "";
}

}  // namespace

std::string means_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"measure", "interface", "target", "sessions", "n", "mean", "sd"});
  for (const MatchingMean& m : evaluation.means) {
    table.row({name_of(m.measure), m.interface, target_name(m.target), sessions(simulated),
               std::to_string(m.n), number(m.mean), number(m.sd)});
  }
  return table.text();
}

std::string shares_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"interface", "target", "sessions", "guesses", "near_guesses", "near_share",
                   "trials", "failures", "failure_share"});
  for (const MatchingShare& s : evaluation.shares) {
    table.row({s.interface, target_name(s.target), sessions(simulated), std::to_string(s.guesses),
               std::to_string(s.near_guesses), share(s.near_guesses, s.guesses),
               std::to_string(s.trials), std::to_string(s.failures), share(s.failures, s.trials)});
  }
  return table.text();
}

std::string time_saved_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table(
      {"first", "second", "target", "sessions", "participants", "saved_s", "low_90", "high_90"});
  for (const MatchingComparison& c : evaluation.comparisons) {
    if (c.measure != MatchingMeasure::time_s) continue;
    table.row({c.first, c.second, target_name(c.target), sessions(simulated),
               std::to_string(c.exact.pairs), number(c.difference.mean),
               number(c.difference.low(0.9)), number(c.difference.high(0.9))});
  }
  return table.text();
}

std::string comparisons_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"measure", "first", "second", "target", "sessions", "participants",
                   "mean_difference", "w_plus", "w_minus", "p_paper", "p_paper_holm", "p_exact",
                   "p_exact_holm", "rank_biserial", "d_z", "t", "p_t"});
  for (const MatchingComparison& c : evaluation.comparisons) {
    table.row({name_of(c.measure), c.first, c.second, target_name(c.target), sessions(simulated),
               std::to_string(c.exact.pairs), number(c.difference.mean), number(c.exact.w_plus),
               number(c.exact.w_minus), p_of_table(c.paper.p), p_of_table(c.paper_holm),
               p_of_table(c.exact.p), p_of_table(c.exact_holm), number(c.exact.rank_biserial),
               number(c.d_z), number(c.difference.t), p_of_table(c.difference.p)});
  }
  return table.text();
}

void write_evaluation(const MatchingEvaluation& evaluation, const MatchingResults& results,
                      const std::filesystem::path& folder) {
  make_folder(folder);
  const bool simulated = results.simulated;
  write_file(folder / "means.csv", means_csv(evaluation, simulated));
  write_file(folder / "shares.csv", shares_csv(evaluation, simulated));
  write_file(folder / "time_saved.csv", time_saved_csv(evaluation, simulated));
  write_file(folder / "comparisons.csv", comparisons_csv(evaluation, simulated));
  write_plot(bar_chart_plot(first_guess_chart(evaluation, simulated)), folder, "first_guess_d");
  write_plot(bar_chart_plot(first_guess_success_chart(evaluation, simulated)), folder,
             "first_guess_success");
  write_plot(bar_chart_plot(time_chart(evaluation, simulated)), folder, "time");
  write_plot(bar_chart_plot(time_saved_chart(evaluation, simulated)), folder, "time_saved");
  write_plot(bar_chart_plot(failures_chart(evaluation, simulated)), folder, "failures");
}

}  // namespace mien::pipeline
