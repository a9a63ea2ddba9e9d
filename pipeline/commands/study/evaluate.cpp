#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/safe_name.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/matching/matching_report.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct EvaluateOptions {
  std::vector<std::string> results;
  std::string out;
  MatchingSettings settings;
  bool json = false;
};

std::string target_text(const std::string& target) { return target.empty() ? "all" : target; }

/// Shows overall results, then those of each target.
void show_text(const MatchingEvaluation& evaluation, const Console& console) {
  const auto show_of = [&](const std::string& target) {
    if (!evaluation.targets.empty()) console.out << target_text(target) << ":\n";
    for (const MatchingMean& m : evaluation.means) {
      if (m.target != target) continue;
      const std::string spread = m.n > 1 ? fmt::format("SD {:.4g}, ", m.sd) : "";
      console.out << fmt::format("{:14} {:12} mean {:.4g}, {}n = {}\n", name_of(m.measure),
                                 m.interface, m.mean, spread, m.n);
    }
    for (const MatchingShare& s : evaluation.shares) {
      if (s.target != target) continue;
      console.out << fmt::format("{}: {} of {} first guesses matched, {} of {} trials failed\n",
                                 s.interface, s.near_guesses, s.guesses, s.failures, s.trials);
    }
    for (const MatchingComparison& c : evaluation.comparisons) {
      if (c.target != target) continue;
      console.out << fmt::format(
          "{:14} {} − {}: {:.4g}, Wilcoxon p = {} (Holm {}), exact {} (Holm {})\n",
          name_of(c.measure), c.first, c.second, c.difference.mean, p_label(c.paper.p),
          p_label(c.normal_holm), p_label(c.exact.p), p_label(c.exact_holm));
    }
  };
  show_of("");
  for (const std::string& target : evaluation.targets) show_of(target);
}

/// A p value as JSON: null if NaN, a text if it is too small for a double.
ordered_json p_json(double p) {
  const std::string text = p_field(p);
  return text.starts_with('<') ? ordered_json(text) : ordered_json(p);
}

ordered_json as_json(const MatchingEvaluation& evaluation, bool simulated, const fs::path& folder) {
  ordered_json means = ordered_json::array();
  for (const MatchingMean& m : evaluation.means)
    means.push_back({{"measure", name_of(m.measure)},
                     {"interface", m.interface},
                     {"target", target_text(m.target)},
                     {"n", m.n},
                     {"mean", m.mean},
                     {"sd", m.sd}});
  ordered_json shares = ordered_json::array();
  for (const MatchingShare& s : evaluation.shares)
    shares.push_back({{"interface", s.interface},
                      {"target", target_text(s.target)},
                      {"guesses", s.guesses},
                      {"near_guesses", s.near_guesses},
                      {"trials", s.trials},
                      {"failures", s.failures}});
  ordered_json comparisons = ordered_json::array();
  for (const MatchingComparison& c : evaluation.comparisons)
    comparisons.push_back({{"measure", name_of(c.measure)},
                           {"first", c.first},
                           {"second", c.second},
                           {"target", target_text(c.target)},
                           {"participants", c.exact.pairs},
                           {"mean_difference", c.difference.mean},
                           {"low_90", c.difference.low(0.9)},
                           {"high_90", c.difference.high(0.9)},
                           {"p_paper", p_json(c.paper.p)},
                           {"p_paper_holm", p_json(c.normal_holm)},
                           {"p_exact", p_json(c.exact.p)},
                           {"p_exact_holm", p_json(c.exact_holm)}});
  return {{"folder", folder.string()},
          {"sessions", simulated ? "simulated" : "given"},
          {"means", means},
          {"shares", shares},
          {"comparisons", comparisons}};
}

fs::path evaluation_folder(const EvaluateOptions& options) {
  if (!options.out.empty()) return options.out;
  const std::string& file = options.results.front();
  return "out" / fs::path(motion::safe_component(fs::path(file).stem().string(), {file}));
}

/// Notes a ceiling effect: every first guess matched, with every interface.
void note_ceiling(const MatchingEvaluation& evaluation, const MatchingResults& results,
                  const Console& console) {
  const auto all_matched = [](const MatchingShare& share) {
    return share.guesses > 0 && share.near_guesses == share.guesses;
  };
  if (evaluation.shares.empty() || !std::ranges::all_of(evaluation.shares, all_matched)) return;
  console.err << fmt::format(
      "note: every first guess matched, so their proportions do not distinguish the interfaces; "
      "use targets farther apart, or a threshold below {:g} m\n",
      results.threshold_m);
}

int run_evaluation(const EvaluateOptions& options, const Console& console) {
  const std::vector<fs::path> files(options.results.begin(), options.results.end());
  const MatchingResults results = read_matching_results(files, options.settings);
  const MatchingEvaluation evaluation = evaluate(results);
  const fs::path folder = evaluation_folder(options);
  write_evaluation(evaluation, results, folder);
  note_ceiling(evaluation, results, console);
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

Command study_evaluate_command() {
  const auto options = std::make_shared<EvaluateOptions>();
  return {
      .name = "evaluate",
      .summary = "Analyse matching sessions: means, tests and figures that compare interfaces",
      .options =
          {argument("results", &options->results,
                    "CSV with the columns participant, target, interface, first_guess_d, time_s, "
                    "success; one file or several"),
           option("-o,--output", &options->out,
                  "Folder for the results (default: out/<name of the first file>)"),
           option("--limit", &options->settings.limit_s,
                  "Time limit in seconds, also used as the time of trials without success "
                  "(default: that of the files, otherwise 300); a value other than theirs is "
                  "refused")
               .positive(),
           option("--threshold", &options->settings.threshold_m,
                  "Distance D in metres below which motions match (default: that of the files, "
                  "otherwise 0.06)")
               .positive(),
           flag("--json", &options->json, "Results as JSON on standard output")},
      .notes =
          "Writes means.csv, shares.csv, time_saved.csv, comparisons.csv and the figures "
          "first_guess_d, first_guess_success, time, time_saved and failures as .pdf, .svg and "
          ".png, each per target and over all targets.\n\n"
          "Examples:\n"
          "  mien study evaluate sessions.csv -o evaluation\n"
          "  mien study evaluate downloads/*trials_data.csv -o evaluation",
      .run = [options](const Console& console) { return run_evaluation(*options, console); }};
}

}  // namespace mien::pipeline
