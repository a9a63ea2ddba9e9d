#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/commands/study/study_subject.h"
#include "pipeline/commands/word_choice.h"
#include "pipeline/study/matching/experiment/starting_distance.h"
#include "pipeline/study/matching/primary_parameters.h"
#include "pipeline/study/matching/target_manifest.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct TargetsCommand {
  StudySubject subject;
  std::string kind = "adjectives";
  std::vector<std::string> parameters;
  TargetOptions sampling;
  std::optional<std::uint64_t> seed;
  std::string out;
};

TargetSet sampled(const TargetsCommand& command, const Repertoire& repertoire) {
  TargetSet set;
  set.are_features = command.kind == "features";
  if (!set.are_features && repertoire.parameters.names.empty()) {
    throw Error("the examples have no ratings", "give --ratings, or sample --from features");
  }
  set.parameters = command.parameters;
  if (set.parameters.empty()) {
    set.parameters = set.are_features ? primary_features() : primary_adjectives(repertoire);
  }
  const ParameterTable& table =
      set.are_features ? repertoire.features.table : repertoire.parameters;
  set.seed = command.sampling.seed;
  set.targets = sample_targets(table, set.parameters, command.sampling);
  return set;
}

std::string ratings_word(const TargetSet& set, const Repertoire& repertoire) {
  if (set.are_features) return "none";
  return repertoire.simulated_ratings ? "simulated" : "given";
}

void show(const TargetSet& set, const std::string& ratings,
          const std::vector<std::string>& examples, const Console& console) {
  console.out << fmt::format("seed {}, ratings {}\n{:12}", set.seed, ratings, "");
  for (const std::string& name : set.parameters) console.out << fmt::format(" {:>18}", name);
  console.out << fmt::format("  {}\n", "nearest example");
  for (const SampledTarget& target : set.targets) {
    console.out << fmt::format("{:12}", target.id);
    for (const double value : target.place) console.out << fmt::format(" {:18.3f}", value);
    console.out << fmt::format("  {} ({:.2f})\n",
                               examples[static_cast<std::size_t>(target.nearest_example)],
                               target.distance);
  }
}

/// With a threshold that untouched sliders do not reach.
Manifest matching_manifest(const Manifest& source, const TargetSet& set) {
  Manifest manifest = target_manifest(source, set);
  Motions motions(manifest);
  const MatchingStudy study = matching_study(manifest, motions);
  manifest.matching->threshold_m = fitting_threshold(starting_distances(manifest, study));
  return manifest;
}

int make_targets(TargetsCommand command, const Console& console) {
  const Manifest manifest = manifest_of(command.subject, console);
  command.sampling.seed = command.seed.value_or(manifest.seed);
  const Repertoire repertoire = load_repertoire(manifest);
  const TargetSet set = sampled(command, repertoire);
  std::vector<std::string> examples;
  for (const RatedExample& example : repertoire.names) examples.push_back(example.name);
  const std::string ratings = ratings_word(set, repertoire);
  show(set, ratings, examples, console);
  if (command.out.empty()) return exit_done;
  const fs::path folder(command.out);
  make_folder(folder);
  write_file(folder / "targets.csv", targets_csv(set, examples, ratings));
  write_file(folder / "targets.yaml",
             target_manifest_yaml(matching_manifest(manifest, set), set, folder));
  console.out << '\n'
              << (folder / "targets.csv").string() << '\n'
              << (folder / "targets.yaml").string() << '\n';
  return exit_done;
}

}  // namespace

void add_study_targets_command(CLI::App& study, Command& chosen) {
  CLI::App* command =
      study.add_subcommand("targets", "Sample motions for a matching experiment to aim at");
  const auto options = std::make_shared<TargetsCommand>();
  add_subject_options(*command, options->subject);
  command->add_option("--from", options->kind, "What the targets are places of")
      ->check(CLI::IsMember({"adjectives", "features"}))
      ->capture_default_str();
  command
      ->add_option("--parameters", options->parameters,
                   "Parameters by name, with commas; the primary groups without it")
      ->delimiter(',');
  command->add_option("--count", options->sampling.targets, "Targets")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command->add_option("--practice", options->sampling.practice, "Practice targets")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  command
      ->add_option("--farthest", options->sampling.farthest_from_example,
                   "Largest distance of a target from its nearest example, in parameters")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  const std::map<std::string, Unreachable> fates = {{"reject", Unreachable::reject},
                                                    {"project", Unreachable::project}};
  command
      ->add_option("--unreachable", options->sampling.unreachable,
                   "Places that no blend of the examples has: reject draws another, project takes "
                   "the nearest place that one has")
      ->transform(choice_of(fates))
      ->option_text("reject|project [reject]");
  const std::map<std::string, TargetSpread> spreads = {{"parameters", TargetSpread::parameters},
                                                       {"everything", TargetSpread::everything}};
  command
      ->add_option("--spread", options->sampling.spread,
                   "What targets are as far from each other as possible in: their own parameters, "
                   "or everything that was rated (with --from features: measured)")
      ->transform(choice_of(spreads))
      ->option_text("parameters|everything [parameters]");
  command->add_option("--seed", options->seed, "Seed of the sampling; the manifest's without it");
  command->add_option("-o,--output", options->out,
                      "Folder for targets.csv and targets.yaml, a manifest that makes them");
  command->footer(
      "\nPlaces are drawn evenly, those far from every example or beyond every blend rejected, and "
      "the most spread ones kept.\n\nExamples:\n"
      "  mien study targets --examples builtin:walks-27 --seed 7 -o out/targets\n"
      "  mien run out/targets/targets.yaml");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return make_targets(*options, console); };
  });
}

}  // namespace mien::pipeline
