#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/commands/study/study.h"
#include "pipeline/matching/matching_tables.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct EvaluateOptions {
  std::vector<std::string> results;
  std::string out;
  MatchingTerms terms;
  bool json = false;
};

void show_text(const MatchingEvaluation& evaluation, const Console& console) {
  for (const MatchingMean& m : evaluation.means) {
    if (!m.target.empty()) continue;
    const std::string spread = m.n > 1 ? fmt::format("SD {:.4g}, ", m.sd) : "";
    console.out << fmt::format("{:14} {:12} mean {:.4g}, {}n = {}\n", name_of(m.measure),
                               m.interface, m.mean, spread, m.n);
  }
  for (const MatchingShare& s : evaluation.shares) {
    console.out << fmt::format("{}: {} of {} first guesses matched, {} of {} trials failed\n",
                               s.interface, s.near_guesses, s.guesses, s.failures, s.trials);
  }
  for (const MatchingComparison& c : evaluation.comparisons) {
    console.out << fmt::format(
        "{:14} {} − {}: {:.4g}, Wilcoxon p = {:.4f} (Holm {:.4f}), exact {:.4f} (Holm {:.4f})\n",
        name_of(c.measure), c.first, c.second, c.difference.mean, c.paper.p, c.paper_holm,
        c.exact.p, c.exact_holm);
  }
}

ordered_json as_json(const MatchingEvaluation& evaluation, bool simulated, const fs::path& folder) {
  ordered_json means = ordered_json::array();
  for (const MatchingMean& m : evaluation.means) {
    means.push_back({{"measure", name_of(m.measure)},
                     {"interface", m.interface},
                     {"target", m.target.empty() ? "all" : m.target},
                     {"n", m.n},
                     {"mean", m.mean},
                     {"sd", m.sd}});
  }
  ordered_json comparisons = ordered_json::array();
  for (const MatchingComparison& c : evaluation.comparisons) {
    comparisons.push_back({{"measure", name_of(c.measure)},
                           {"first", c.first},
                           {"second", c.second},
                           {"mean_difference", c.difference.mean},
                           {"p_paper", c.paper.p},
                           {"p_paper_holm", c.paper_holm},
                           {"p_exact", c.exact.p},
                           {"p_exact_holm", c.exact_holm}});
  }
  return {{"folder", folder.string()},
          {"sessions", simulated ? "simulated" : "given"},
          {"means", means},
          {"comparisons", comparisons}};
}

int run_evaluation(const EvaluateOptions& options, const Console& console) {
  const std::vector<fs::path> files(options.results.begin(), options.results.end());
  const MatchingResults results = read_matching_results(files, options.terms);
  const MatchingEvaluation evaluation = evaluate(results);
  const fs::path folder =
      options.out.empty() ? "out" / files.front().stem() : fs::path(options.out);
  write_evaluation(evaluation, results, folder);
  if (options.json) {
    console.out << as_json(evaluation, results.simulated, folder).dump(2) << '\n';
    return exit_done;
  }
  show_text(evaluation, console);
  if (results.simulated) console.out << "simulated sessions\n";
  console.out << folder.string() << '\n';
  return exit_done;
}

}  // namespace

void add_study_evaluate_command(CLI::App& study, Command& chosen) {
  CLI::App* command = study.add_subcommand(
      "evaluate", "From matching sessions to means, tests and figures that compare interfaces");
  const auto options = std::make_shared<EvaluateOptions>();
  command
      ->add_option("results", options->results,
                   "CSV with the columns participant, target, interface, first_guess_d, time_s, "
                   "success; one of all participants, or several")
      ->required();
  command->add_option("-o,--output", options->out,
                      "Folder for the results; out/<name of the first file> without it");
  command
      ->add_option("--limit", options->terms.limit_s,
                   "Seconds allowed for a match; trials without success count as that long; 300 "
                   "where the files do not tell")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--threshold", options->terms.threshold_m,
                   "Distance D below which motions match, metres; 0.06 where the files do not tell")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "Results as JSON on standard output");
  command->footer(
      "\nWrites means.csv, shares.csv, time_saved.csv, comparisons.csv and the figures "
      "first_guess_d, first_guess_success, time, time_saved and failures as .pdf, .svg and .png.\n"
      "\nExample:\n  mien study evaluate sessions.csv -o evaluation"
      "\n  mien study evaluate downloads/*trials_data.csv -o evaluation");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return run_evaluation(*options, console); };
  });
}

}  // namespace mien::pipeline
