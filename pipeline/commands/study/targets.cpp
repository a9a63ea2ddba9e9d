#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/table.h"
#include "pipeline/commands/study/new_tables.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/matching/target_manifest.h"
#include "pipeline/study/matching/target_sampling.h"

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
  if (!set.are_features && repertoire.parameters.names.empty())
    throw Error("the examples have no ratings", "give --ratings, or sample --from features");
  set.parameters = command.parameters;
  if (set.parameters.empty())
    set.parameters = set.are_features ? primary_features() : primary_adjectives(repertoire);
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

/// A manifest for matching these targets, with a threshold that untouched sliders do not reach.
Manifest matching_manifest(const Manifest& source, const TargetSet& set) {
  Manifest manifest = target_manifest(source, set);
  Motions motions(manifest);
  const MatchingStudy study = matching_study(manifest, motions);
  manifest.matching->threshold_m = suggested_threshold(starting_distances(manifest, study));
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
  const WrittenTable table = targets_table(set, examples, ratings);
  const std::string yaml = target_manifest_yaml(matching_manifest(manifest, set), set, folder);
  refuse_data_loss({{folder / "targets.csv", table.csv}}, {});
  refuse_other_content(folder / "targets.yaml", yaml);
  write_tables(folder, {table});
  write_file(folder / "targets.yaml", yaml);
  console.out << '\n'
              << (folder / "targets.csv").string() << '\n'
              << (folder / "targets.yaml").string() << '\n';
  return exit_done;
}

}  // namespace

Command study_targets_command() {
  const auto options = std::make_shared<TargetsCommand>();
  return {
      .name = "targets",
      .summary = "Sample target motions for a matching experiment",
      .options = all_of(
          subject_and_recording_options(options->subject),
          option("--from", &options->kind, "Space in which targets are sampled")
              .one_of({"adjectives", "features"})
              .with_default(),
          option("--parameters", &options->parameters,
                 "Parameters, separated by commas (default: the primary groups)")
              .with_commas(),
          option("--count", &options->sampling.targets, "Number of targets")
              .between(1, 100)
              .with_default(),
          option("--practice", &options->sampling.practice, "Number of practice targets")
              .between(0, 100)
              .with_default(),
          option("--max-distance", &options->sampling.max_distance,
                 "Largest distance of a target from its nearest example, in parameter units")
              .formerly("--farthest")
              .positive()
              .with_default(),
          choice("--unreachable", options->sampling.unreachable,
                 {{"reject", UnreachablePolicy::reject}, {"project", UnreachablePolicy::project}},
                 "Samples that no blend of the examples reaches: reject draws another, project "
                 "moves to the nearest feasible point"),
          choice(
              "--spread", options->sampling.spread,
              {{"parameters", TargetSpread::parameters}, {"everything", TargetSpread::everything}},
              "Space in which targets are spread as far apart as possible: their own parameters, "
              "or everything: all rated scales and groups or, with --from features, all features"),
          option("--seed", &options->seed, "Seed of the sampling; default: as in the manifest"),
          option("-o,--output", &options->out,
                 "Folder for targets.csv and targets.yaml, a manifest of the targets")),
      .notes =
          "Samples are drawn uniformly; those far from every example or not reachable by any "
          "blend are rejected, and the most widely spread ones are kept.\n\n"
          "Examples:\n"
          "  mien study targets --examples builtin:walks-27 --seed 7 -o out/targets\n"
          "  mien run out/targets/targets.yaml",
      .run = [options](const Console& console) { return make_targets(*options, console); }};
}

}  // namespace mien::pipeline
