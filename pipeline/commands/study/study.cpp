#include "pipeline/commands/study/study.h"

#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "pipeline/analysis/scales_yaml.h"
#include "pipeline/documents/files.h"
#include "pipeline/manifest/example_source.h"
#include "pipeline/synthesis/repertoire.h"

namespace mien::pipeline {

namespace {

struct SimulateOptions {
  std::string examples;
  std::string scales;
  std::string out;
  int raters = 14;
  std::uint64_t seed = 0;
};

int simulate(const SimulateOptions& options, const Console& console) {
  Manifest manifest;
  manifest.examples = parse_examples(options.examples);
  if (!options.scales.empty()) manifest.scales = scales_in(options.scales);
  manifest.ratings.source = Ratings::Source::simulated;
  manifest.ratings.raters = options.raters;
  manifest.seed = options.seed;
  const std::string csv = to_csv(simulated_answers(manifest));
  if (options.out.empty()) {
    console.out << csv;
  } else {
    write_file(options.out, csv);
    console.out << options.out << ": answers of " << options.raters << " simulated raters\n";
  }
  return exit_done;
}

void add_simulate_command(CLI::App& study, Command& chosen) {
  CLI::App* command = study.add_subcommand(
      "simulate", "Answers that nobody gave, from what is measured of the motions");
  const auto options = std::make_shared<SimulateOptions>();
  command->add_option("--examples", options->examples, examples_help)->required();
  command->add_option("--scales", options->scales,
                      "Scales file (YAML); the 41 built-in adjective pairs without one");
  command->add_option("--raters", options->raters, "How many raters")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed")->capture_default_str();
  command->add_option("-o,--output", options->out, "CSV to write; standard output without it");
  command->footer(
      "\nEvery row is marked as simulated. Examples:\n"
      "  mien study simulate --examples builtin:walks-27 -o answers.csv\n"
      "  mien study simulate --examples 'captures/*walk*.bvh' --scales five.scales.yaml");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return simulate(*options, console); };
  });
}

void add_scales_command(CLI::App& study, Command& chosen) {
  CLI::App* command = study.add_subcommand(
      "scales", "The 41 built-in adjective pairs as a scales file, to begin one's own with");
  command->footer("\nExample:\n  mien study scales > my.scales.yaml");
  command->callback([&chosen] {
    chosen = [](const Console& console) {
      console.out << adjective_pairs_yaml();
      return exit_done;
    };
  });
}

}  // namespace

void add_subject_options(CLI::App& command, StudySubject& subject) {
  command
      .add_option("--examples", subject.examples,
                  std::string("Examples: a manifest, ") + examples_help)
      ->required();
  command.add_option("--ratings", subject.ratings,
                     "Answers (CSV); otherwise those of the manifest or the built-in set");
  command.add_option("--scales", subject.scales,
                     "Scales file (YAML); otherwise the manifest's or the 41 adjective pairs");
}

void add_study_command(CLI::App& app, Command& chosen) {
  CLI::App* study = app.add_subcommand("study", "Rating studies");
  study->require_subcommand(1);
  add_study_analyze_command(*study, chosen);
  add_study_evaluate_command(*study, chosen);
  add_study_export_command(*study, chosen);
  add_study_features_command(*study, chosen);
  add_study_interfaces_command(*study, chosen);
  add_study_methods_command(*study, chosen);
  add_study_predict_command(*study, chosen);
  add_scales_command(*study, chosen);
  add_simulate_command(*study, chosen);
  add_study_targets_command(*study, chosen);
  add_study_words_command(*study, chosen);
}

}  // namespace mien::pipeline
