#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/safe_name.h"
#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/analysis/analysis.h"
#include "pipeline/study/analysis/analysis_report.h"
#include "pipeline/study/analysis/calibration.h"
#include "pipeline/study/analysis/published_clusters.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

fs::path folder_of_study(const fs::path& study) {
  return fs::is_directory(study) ? study : fs::absolute(study).parent_path().parent_path();
}

/// The scales file stored with a study's results in inputs/; none if it uses the built-in pairs or
/// stores no inputs. `study` is its folder, or its metrics/parameters.csv.
std::optional<fs::path> stored_scales(const fs::path& study) {
  const auto record = study_record_in(folder_of_study(study) / "provenance.json");
  if (!record || !fs::is_regular_file(record->as_run)) return std::nullopt;
  // Motions of the study may no longer exist: only faults of the scales matter, which are reported
  // when they are read.
  const fs::path scales = read_manifest(record->as_run, process_environment()).manifest.scales.file;
  if (scales.empty()) return std::nullopt;
  return scales;
}

struct AnalyzeOptions {
  std::string answers;
  std::string examples;
  RecordingArguments recording;  ///< how the files of the examples are read
  std::string stimuli;           ///< folder of a study, or its parameters.csv
  std::string scales;
  std::string out;
  std::string clusters = "4";
  AnalysisOptions analysis;
  AnswerRules rules;
  bool json = false;
};

std::optional<int> cluster_count(const std::string& text) {
  if (text == "gap") return std::nullopt;
  const bool digits = !text.empty() && text.size() <= 4 &&
                      text.find_first_not_of("0123456789") == std::string::npos;
  const int count = digits ? std::stoi(text) : 0;
  if (count >= 1) return count;
  throw Error("--clusters: \"" + text + "\" is neither a number nor \"gap\"",
              "write a number of clusters, or gap for the number suggested by the largest gap");
}

void show_warnings(const std::vector<StudyWarning>& warnings, const fs::path& folder,
                   const Console& console) {
  constexpr int shown = 3;
  std::map<std::string, int> counts;
  for (const StudyWarning& warning : warnings) {
    if (++counts[warning.kind] > shown) continue;
    const std::string place = to_string(warning.place);
    console.err << (place.empty() ? "" : place + ": ") << warning.text << '\n';
  }
  for (const auto& [kind, count] : counts) {
    if (count <= shown) continue;
    console.err << fmt::format("… {} more warnings of the kind \"{}\" in {}\n", count - shown, kind,
                               (folder / "warnings.csv").string());
  }
}

void show_text(const Analysis& analysis, const ScaleSet& scales, const fs::path& folder,
               const Console& console) {
  const auto count = [&](auto condition) {
    return std::ranges::count_if(analysis.quantities, condition);
  };
  console.out << fmt::format("{} of {} scales kept; {} removed as neutral, {} for disagreement\n",
                             count([](const Quantity& q) { return q.retained(); }),
                             analysis.quantities.size(),
                             count([](const Quantity& q) { return q.neutral; }),
                             count([](const Quantity& q) { return q.disputed; }));
  console.out << fmt::format("{} clusters of {} scales; the largest gap suggests {}\n",
                             analysis.clusters.size(), analysis.none_retained ? "all" : "the kept",
                             analysis.suggested_clusters);
  for (const ScaleCluster& cluster : analysis.clusters)
    console.out << fmt::format("  {:14} {:3} scale{} around {}\n", cluster.name,
                               cluster.members.size(), cluster.members.size() == 1 ? " " : "s",
                               central_words(analysis, cluster, scales));
  for (const PublishedComparison& c : compare_with_published(analysis))
    console.out << fmt::format(
        "{}: {} pairs kept in both, {} only here, {} only there; Rand {:.3f}, adjusted {:.3f}\n",
        c.table, c.retained_in_both, c.retained_only_here, c.retained_only_published, c.rand,
        c.adjusted_rand);
  if (analysis.impressions.simulated) console.out << "simulated ratings\n";
  console.out << folder.string() << '\n';
}

ordered_json as_json(const Analysis& analysis, const ScaleSet& scales, const fs::path& folder) {
  ordered_json clusters = ordered_json::array();
  for (const ScaleCluster& cluster : analysis.clusters) {
    ordered_json members = ordered_json::array();
    for (const int row : cluster.members)
      members.push_back(analysis.impressions.scales[static_cast<size_t>(row)]);
    clusters.push_back({{"name", cluster.name},
                        {"scales", members},
                        {"around", central_words(analysis, cluster, scales)}});
  }
  ordered_json published = ordered_json::array();
  for (const PublishedComparison& c : compare_with_published(analysis))
    published.push_back({{"table", c.table},
                         {"kept_in_both", c.retained_in_both},
                         {"rand", c.rand},
                         {"adjusted_rand", c.adjusted_rand}});
  return {{"folder", folder.string()},
          {"ratings", analysis.impressions.simulated ? "simulated" : "given"},
          {"scales", analysis.quantities.size()},
          {"kept", std::ranges::count_if(analysis.quantities, &Quantity::retained)},
          {"clusters_are_of", analysis.none_retained ? "all" : "kept"},
          {"suggested_clusters", analysis.suggested_clusters},
          {"clusters", clusters},
          {"published", published},
          {"warnings", analysis.warnings.size()}};
}

fs::path folder_for(const AnalyzeOptions& options) {
  if (!options.out.empty()) return options.out;
  const std::string name = fs::path(options.answers).stem().string();
  return "out" / fs::path(motion::safe_component(name, {options.answers}));
}

void show_corrections(const Calibration& calibration, const fs::path& folder,
                      const Console& console) {
  if (calibration.simulated) console.out << "simulated ratings\n";
  for (const Correction& c : calibration.corrections)
    console.out
        << (c.is_usable()
                ? fmt::format(
                      "{}: perceived = {:.3f} + {:.3f} · requested ({} stimuli, r² {:.2f})\n",
                      c.parameter, c.intercept, c.slope, c.stimuli, c.r_squared)
                : fmt::format("{}: ratings did not increase with the requested value ({} stimuli); "
                              "no correction possible\n",
                              c.parameter, c.stimuli));
  console.out << folder.string() << '\n';
}

/// The scales given on the command line, or those of the study, which is reported.
ScaleSet scales_of_answers(const AnalyzeOptions& options, const Console& console) {
  if (!options.scales.empty()) return read_scales(options.scales);
  const std::optional<fs::path> retained = stored_scales(options.stimuli);
  if (!retained) return builtin_scales();
  console.out << "scales of the study: " << retained->string() << '\n';
  return read_scales(*retained);
}

/// Analyses ratings of a study's stimuli: compares requested with perceived parameters.
int calibrate_stimuli(const AnalyzeOptions& options, const Console& console) {
  const ScaleSet scales = scales_of_answers(options, console);
  std::vector<Fault> warnings;
  const std::vector<StimulusParameter> made = read_stimulus_parameters(options.stimuli, warnings);
  print_warnings(warnings, console);
  AnswerRules rules = options.rules;
  rules.left_out = other_stimuli(options.stimuli, made);
  const StudyAnswers answers = read_study_answers(options.answers, scales, stimuli_of(made), rules);
  const Calibration calibration = calibrate(made, answers.plain(), scales);
  const fs::path folder = folder_for(options);
  write_tables(folder, {calibration_table(calibration), corrections_table(calibration),
                        warnings_table(answers.warnings)});
  write_plot(calibration_chart(calibration), folder, "calibration");
  show_warnings(answers.warnings, folder, console);
  show_corrections(calibration, folder, console);
  return exit_done;
}

int analyze(AnalyzeOptions options, const Console& console) {
  if (!options.stimuli.empty()) return calibrate_stimuli(options, console);
  if (options.examples.empty())
    throw Error("the rated stimuli were not specified",
                "give --examples, or --stimuli with the folder of a study");
  options.analysis.clusters = cluster_count(options.clusters);
  const Manifest subject =
      manifest_of({options.examples, "", options.scales, options.recording}, console);
  const ScaleSet scales =
      subject.scales.file.empty() ? builtin_scales() : read_scales(subject.scales.file);
  const std::vector<RatedExample> examples = rated_examples(subject);
  const StudyAnswers answers = read_study_answers(options.answers, scales, examples, options.rules);
  const Analysis analysis = analyse(answers, scales, examples, options.analysis);
  const fs::path folder = folder_for(options);
  write_analysis(analysis, scales, options.analysis.thresholds, folder);
  show_warnings(analysis.warnings, folder, console);
  if (options.json) {
    console.out << as_json(analysis, scales, folder).dump(2) << '\n';
  } else {
    show_text(analysis, scales, folder, console);
  }
  return exit_done;
}

std::vector<CommandOption> rule_options(AnswerRules& rules) {
  using Rules = AnswerRules;
  return {choice("--repeated", rules.repeated,
                 {{"error", Rules::Repeated::refuse},
                  {"first", Rules::Repeated::first},
                  {"last", Rules::Repeated::last},
                  {"mean", Rules::Repeated::mean}},
                 "Repeated answers of a participant about the same stimulus and scale"),
          choice("--unknown", rules.unknown,
                 {{"error", Rules::Unknown::refuse}, {"ignore", Rules::Unknown::ignore}},
                 "Answers about unknown stimuli or on unknown scales"),
          choice("--constant", rules.constant,
                 {{"drop", Rules::Constant::drop}, {"keep", Rules::Constant::keep}},
                 "Participants who give the same answer throughout (straight-lining)"),
          choice("--missing", rules.missing,
                 {{"error", Rules::Missing::refuse}, {"ignore", Rules::Missing::ignore}},
                 "Missing answers")};
}

}  // namespace

Command study_analyze_command() {
  const auto options = std::make_shared<AnalyzeOptions>();
  return {
      .name = "analyze",
      .summary = "Cluster the scales of a rating study into primary parameters",
      .options = all_of(
          argument("answers", &options->answers,
                   "CSV with the columns participant, stimulus, scale, value and optionally rt_ms, "
                   "order, comment"),
          option("--examples", &options->examples,
                 "Rated examples: " + std::string(examples_help) + ", or a manifest"),
          that_need("--examples", recording_options(options->recording)),
          option("--stimuli", &options->stimuli,
                 "Rated stimuli of a study instead: its folder (out/my-study). Compares requested, "
                 "reached and perceived values, and gives corrected values for the next round")
              .excludes("--examples"),
          option("--scales", &options->scales,
                 "Scales file (YAML); default: that of the manifest or study, or the 41 built-in "
                 "adjective pairs"),
          option("-o,--output", &options->out,
                 "Folder for the results (default: out/<name of the answers>)"),
          option("--max-mean", &options->analysis.thresholds.largest_mean,
                 "Remove scales whose largest |mean| over the examples is below this, for answers "
                 "from -2 to 2 (scaled for other ranges)")
              .between(0.0, 2.0)
              .with_default(),
          option("--max-sd", &options->analysis.thresholds.mean_deviation,
                 "Remove scales whose mean SD over the examples is above this, for answers from -2 "
                 "to 2 (scaled for other ranges)")
              .between(0.0, 4.0)
              .with_default(),
          choice("--sd", options->analysis.deviation,
                 {{"population", Deviation::population}, {"sample", Deviation::sample}},
                 "Divisor of the variance of an example's answers: n or n - 1"),
          option("--clusters", &options->clusters,
                 "Number of clusters, or gap: cut at the largest gap between merge heights (not "
                 "the gap statistic)")
              .with_default(),
          option("--names", &options->analysis.names,
                 "Names of the clusters in the order of clusters.csv")
              .with_commas(),
          rule_options(options->rules),
          flag("--json", &options->json, "Results as JSON on standard output")),
      .notes =
          "Writes quantification.csv, thresholds.csv, impressions.csv, linkage.csv, clusters.csv, "
          "primary.csv, agreement.csv, warnings.csv, clusters.scales.yaml (for `scales:` in a "
          "manifest), dendrogram and thresholds as .pdf, .svg, .png; for the built-in adjective "
          "pairs also published.csv, a comparison with the published clusters. With --stimuli: "
          "calibration.csv, corrections.csv, warnings.csv, and calibration as .pdf, .svg, "
          ".png.\n\nExamples:\n"
          "  mien study analyze answers.csv --examples builtin:walks-27\n"
          "  mien study analyze answers.csv --examples study.yaml --clusters gap --unknown ignore\n"
          "  mien study analyze answers.csv --stimuli out/my-study",
      .run = [options](const Console& console) { return analyze(*options, console); }};
}

}  // namespace mien::pipeline
