#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/matching/method_comparison.h"
#include "pipeline/study/matching/target_sampling.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct MethodsCommand {
  StudySubject subject;
  std::vector<std::string> parameters;
  std::vector<motion::InterpolationMethod> methods;
  MethodComparisonOptions trial;
  std::optional<std::uint64_t> seed;
  std::string out;
};

void show(const std::vector<MethodResult>& trials, bool simulated, const Console& console) {
  if (simulated) console.out << "Simulated ratings.\n\n";
  console.out << fmt::format("{:17} {:>10} {:>13} {:>7} {:>18} {:>8} {:>10}\n", "method",
                             "mean error", "largest error", "jump", "effective examples", "D (m)",
                             "time (ms)");
  for (const MethodResult& t : trials)
    console.out << fmt::format("{:17} {:10.4f} {:13.4f} {:7.3f} {:18.1f} {:8.4f} {:10.3f}\n",
                               motion::name_of(t.method), t.mean_error, t.worst_error, t.jump,
                               t.mean_examples, t.mean_distance, 1000.0 * t.seconds);
}

int compare(MethodsCommand command, const Console& console) {
  const Manifest manifest = manifest_of(command.subject, console);
  const Repertoire repertoire = load_repertoire(manifest);
  if (repertoire.parameters.names.empty())
    throw Error("the examples have no ratings", "give --ratings");
  command.trial.seed = command.seed.value_or(manifest.seed);
  if (command.parameters.empty()) command.parameters = primary_adjectives(repertoire);
  if (command.methods.empty()) command.methods = methods_with_parameters();
  const std::vector<MethodResult> trials = compare_methods(
      repertoire, command.parameters, command.methods, manifest.interpolation, command.trial);
  show(trials, repertoire.simulated_ratings, console);
  if (command.out.empty()) return exit_done;
  write_tables(command.out, {method_results_table(trials, repertoire.simulated_ratings)});
  console.out << '\n' << (fs::path(command.out) / "methods.csv").string() << '\n';
  return exit_done;
}

}  // namespace

Command study_methods_command() {
  const auto options = std::make_shared<MethodsCommand>();
  return {
      .name = "methods",
      .summary = "Compare the interpolation methods on feasible requests",
      .options = all_of(
          subject_and_recording_options(options->subject),
          option("--parameters", &options->parameters,
                 "Parameters, separated by commas (default: the primary groups)")
              .with_commas(),
          methods_option(options->methods, "default: all"),
          option("--settings", &options->trial.settings, "Number of requests (settings) to try")
              .formerly("--wishes")
              .between(2, 10000)
              .with_default(),
          option("--seed", &options->seed, "Seed; default: as in the manifest"),
          option("-o,--output", &options->out, "Folder for methods.csv")),
      .notes =
          "Requests are the parameters of random blends of three examples, so each is "
          "feasible. The error of a request is the largest deviation of any parameter; mean error "
          "and largest error: over the requests; jump: the largest change of any weight in "
          "a step of 1 % of the straight line between two successive requests; effective examples: "
          "1/sum of squared weights; D: distance to "
          "the blend from which the request was taken; time: to compute the weights.\n\n"
          "Example:\n"
          "  mien study methods --examples builtin:walks-27",
      .run = [options](const Console& console) { return compare(*options, console); }};
}

}  // namespace mien::pipeline
