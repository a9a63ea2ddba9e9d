#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/matching/simulated_evaluation.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct InterfacesCommand {
  StudySubject subject;
  int targets = 5;
  EvaluationOptions evaluation;
  std::optional<std::uint64_t> seed;
  std::string out;
};

void show(const std::vector<InterfaceSummary>& summaries, const Console& console) {
  console.out << "Simulated participants.\n\n";
  console.out << fmt::format("{:17} {:11} {:>12} {:>6} {:>17} {:>8} {:>17} {:>8} {:>6}\n", "method",
                             "interface", "settings", "count", "D, first (m)", "matches",
                             "D, last (m)", "failed", "looks");
  for (const InterfaceSummary& s : summaries) {
    const std::string way = s.step > 0.0 ? fmt::format("nearest {:g}", s.step) : "user";
    console.out << fmt::format(
        "{:17} {:11} {:>12} {:6} {:8.4f} ± {:6.4f} {:6.0f} % {:8.4f} ± {:6.4f} {:6.0f} % {:6.1f}\n",
        motion::name_of(s.method), name_of(s.kind), way, s.count, s.mean_first, s.sd_first,
        100.0 * s.first_success, s.mean_last, s.sd_last, 100.0 * s.failure, s.mean_views);
  }
}

void write_all(const fs::path& folder, const std::vector<InterfaceResult>& results,
               const std::vector<InterfaceSummary>& summaries, double threshold,
               const Console& console) {
  write_tables(folder, {results_table(results), summary_table(summaries)});
  std::vector<motion::InterpolationMethod> methods;
  for (const InterfaceSummary& s : summaries)
    if (std::find(methods.begin(), methods.end(), s.method) == methods.end())
      methods.push_back(s.method);
  for (const motion::InterpolationMethod method : methods) {
    std::vector<InterfaceSummary> own;
    std::copy_if(summaries.begin(), summaries.end(), std::back_inserter(own),
                 [&](const InterfaceSummary& s) { return s.method == method; });
    const std::string suffix =
        methods.size() == 1 ? "" : "-" + std::string(motion::name_of(method));
    write_plot(simulated_chart(own, threshold), folder, "interfaces" + suffix);
  }
  console.out << "\ntables and figure in " << folder.string() << '\n';
}

int evaluate(InterfacesCommand command, const Console& console) {
  const Manifest manifest = manifest_of(command.subject, console);
  const Repertoire repertoire = load_repertoire(manifest);
  command.evaluation.seed = command.seed.value_or(manifest.seed);
  const SliderInterface first = interfaces_of(repertoire).front();
  const bool by_features = first.kind == InterfaceKind::features;
  const auto targets =
      sample_targets(by_features ? repertoire.features.table : repertoire.parameters, first.sliders,
                     {.targets = command.targets, .practice = 0, .seed = command.evaluation.seed});
  const auto results =
      evaluate_interfaces(repertoire, targets, manifest.interpolation, command.evaluation);
  const auto summaries = summarise(results);
  show(summaries, console);
  if (!command.out.empty())
    write_all(command.out, results, summaries, command.evaluation.threshold, console);
  return exit_done;
}

}  // namespace

Command study_interfaces_command() {
  const auto options = std::make_shared<InterfacesCommand>();
  return {
      .name = "interfaces",
      .summary = "Compare sliders for adjectives, features and weights with simulated users",
      .options = all_of(
          subject_and_recording_options(options->subject),
          option("--targets", &options->targets, "Number of targets")
              .between(1, 100)
              .with_default(),
          option("--users", &options->evaluation.users,
                 "Number of simulated users per target and interface")
              .between(0, 1000)
              .with_default(),
          option(
              "--steps", &options->evaluation.steps,
              "Step widths of slider grids, separated by commas; for each, the setting nearest to "
              "the target is evaluated")
              .with_commas()
              .between(0.01, 1.0)
              .with_default(),
          option("--threshold", &options->evaluation.threshold,
                 "Distance D in metres below which motions match")
              .positive()
              .with_default(),
          methods_option(options->evaluation.methods, "default: as in the manifest"),
          option("--seed", &options->seed, "Seed; default: as in the manifest"),
          option("-o,--output", &options->out, "Folder for the tables and the figure")),
      .notes =
          "For every target (sampled as by mien study targets) and interface: the distance D "
          "of the nearest slider setting, and that reached by simulated users. A simulated user "
          "estimates "
          "the settings of the target with an error of 0.15 (SD), then moves one slider at a "
          "time up and down by 0.2, later by less, keeping whichever looks closer (perceived "
          "distances have an error of 10 %), over at most 100 motions. This shows what the "
          "interfaces allow, not what people achieve with them: people estimate a motion's "
          "quickness better than its example weights.\n\n"
          "Example:\n"
          "  mien study interfaces --examples builtin:walks-27 -o out/interfaces",
      .run = [options](const Console& console) { return evaluate(*options, console); }};
}

}  // namespace mien::pipeline
