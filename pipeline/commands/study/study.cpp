#include "pipeline/commands/study/study.h"

#include <string>

#include <CLI/CLI.hpp>

#include "pipeline/manifest/example_source.h"
#include "pipeline/study/analysis/scales_yaml.h"

namespace mien::pipeline {

namespace {

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
  add_study_design_command(*study, chosen);
  add_study_evaluate_command(*study, chosen);
  add_study_export_command(*study, chosen);
  add_study_features_command(*study, chosen);
  add_study_interfaces_command(*study, chosen);
  add_study_methods_command(*study, chosen);
  add_study_predict_command(*study, chosen);
  add_scales_command(*study, chosen);
  add_study_serve_command(*study, chosen);
  add_study_report_command(*study, chosen);
  add_study_simulate_command(*study, chosen);
  add_study_targets_command(*study, chosen);
  add_study_words_command(*study, chosen);
}

}  // namespace mien::pipeline
