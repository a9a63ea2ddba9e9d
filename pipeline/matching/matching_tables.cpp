#include "pipeline/matching/matching_tables.h"

#include <cmath>

#include "pipeline/documents/csv.h"
#include "pipeline/documents/files.h"
#include "pipeline/matching/matching_charts.h"

namespace mien::pipeline {

namespace {

std::string sessions(bool simulated) { return simulated ? "simulated" : "given"; }

std::string number(double value) { return std::isfinite(value) ? shortest(value) : ""; }

std::string share(int part, int all) {
  return all > 0 ? shortest(part / static_cast<double>(all)) : "";
}

}  // namespace

std::string means_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"measure", "interface", "target", "sessions", "n", "mean", "sd"});
  for (const MatchingMean& m : evaluation.means) {
    table.row({name_of(m.measure), m.interface, m.target.empty() ? "all" : m.target,
               sessions(simulated), std::to_string(m.n), number(m.mean), number(m.sd)});
  }
  return table.text();
}

std::string shares_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"interface", "sessions", "guesses", "near_guesses", "near_share", "trials",
                   "failures", "failure_share"});
  for (const MatchingShare& s : evaluation.shares) {
    table.row({s.interface, sessions(simulated), std::to_string(s.guesses),
               std::to_string(s.near_guesses), share(s.near_guesses, s.guesses),
               std::to_string(s.trials), std::to_string(s.failures), share(s.failures, s.trials)});
  }
  return table.text();
}

std::string time_saved_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"first", "second", "sessions", "participants", "saved_s", "low_90", "high_90"});
  for (const MatchingComparison& c : evaluation.comparisons) {
    if (c.measure != MatchingMeasure::time_s) continue;
    table.row({c.first, c.second, sessions(simulated), std::to_string(c.exact.pairs),
               number(c.difference.mean), number(c.difference.low(0.9)),
               number(c.difference.high(0.9))});
  }
  return table.text();
}

std::string comparisons_csv(const MatchingEvaluation& evaluation, bool simulated) {
  CsvWriter table({"measure", "first", "second", "sessions", "participants", "mean_difference",
                   "w_plus", "w_minus", "p_paper", "p_paper_holm", "p_exact", "p_exact_holm",
                   "rank_biserial", "d_z", "t", "p_t"});
  for (const MatchingComparison& c : evaluation.comparisons) {
    table.row({name_of(c.measure), c.first, c.second, sessions(simulated),
               std::to_string(c.exact.pairs), number(c.difference.mean), number(c.exact.w_plus),
               number(c.exact.w_minus), number(c.paper.p), number(c.paper_holm), number(c.exact.p),
               number(c.exact_holm), number(c.exact.rank_biserial), number(c.d_z),
               number(c.difference.t), number(c.difference.p)});
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
