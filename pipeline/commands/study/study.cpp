#include "pipeline/commands/study/study.h"

#include <filesystem>

#include "pipeline/commands/line/examples_option.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/line/program.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/example_source.h"
#include "pipeline/production/archive/tar_archive.h"
#include "pipeline/study/analysis/scales_yaml.h"
#include "pipeline/study/server/database.h"
#include "pipeline/study/server/http_server.h"

namespace mien::pipeline {

namespace {

Command scales_command() {
  return {.name = "scales",
          .summary = "Print the 41 built-in adjective pairs as a scales file, as a starting point",
          .notes = "Example:\n  mien study scales > my.scales.yaml",
          .run = [](const Console& console) {
            console.out << adjective_pairs_yaml();
            return exit_done;
          }};
}

}  // namespace

std::vector<motion::InterpolationMethod> methods_with_parameters() {
  using enum motion::InterpolationMethod;
  return {reach, cardinal, nearest, inverse_distance, grid, kriging, pca, incremental};
}

CommandOption methods_option(std::vector<motion::InterpolationMethod>& methods,
                             const std::string& otherwise) {
  WordValues<motion::InterpolationMethod> by_name;
  for (const motion::InterpolationMethod method : methods_with_parameters())
    by_name.emplace_back(motion::name_of(method), method);
  return choice("--methods", methods, by_name,
                "Interpolation methods to try, separated by commas; " + otherwise);
}

Manifest questionnaire_manifest(const std::string& name, const Console& console) {
  Manifest manifest = load_with_warnings(resolve_manifest(name, console), {}, console);
  questionnaire_of(manifest);
  return manifest;
}

Manifest participants_manifest(const std::string& name, const Console& console) {
  Manifest manifest = load_with_warnings(resolve_manifest(name, console), {}, console);
  if (!manifest.matching && !manifest.adaptive) questionnaire_of(manifest);
  return manifest;
}

Manifest manifest_of(const StudySubject& subject, const Console& console) {
  const std::filesystem::path file(subject.examples);
  Manifest manifest;
  if (file.extension() == ".yaml" || file.extension() == ".yml") {
    refuse_recording_options(subject.recording, "a manifest",
                             "set take:, subject:, fps: and joints: in the manifest");
    manifest = load_with_warnings(resolve_input_file(subject.examples, console), {}, console);
    refuse_unblendable(manifest.examples);
  } else {
    manifest.examples = examples_of(subject.examples, subject.recording);
    if (!manifest.examples.builtin.empty()) manifest.ratings.source = Ratings::Source::builtin;
  }
  if (!subject.ratings.empty()) {
    manifest.ratings.source = Ratings::Source::file;
    manifest.ratings.file = subject.ratings;
  }
  if (!subject.scales.empty()) manifest.scales = scales_in(subject.scales);
  return manifest;
}

std::vector<CommandOption> subject_options(StudySubject& subject) {
  return {
      option("--examples", &subject.examples, std::string("Examples: a manifest, ") + examples_help)
          .required(),
      option("--ratings", &subject.ratings,
             "Answers (CSV) (default: those of the manifest or built-in set)"),
      option("--scales", &subject.scales,
             "Scales file (YAML) (default: that of the manifest, or the 41 adjective pairs)")};
}

std::vector<CommandOption> subject_and_recording_options(StudySubject& subject) {
  return all_of(subject_options(subject), recording_options(subject.recording));
}

Command study_command() {
  return {
      .name = study_program.command,
      .summary = study_program.summary,
      .commands =
          {study_analyze_command(),
           study_chains_command(),
           study_design_command(),
           study_estimate_command(),
           study_evaluate_command(),
           study_export_command(),
           study_features_command(),
           study_interfaces_command(),
           study_methods_command(),
           study_next_command(),
           study_predict_command(),
           study_recipes_command(),
           scales_command(),
           study_serve_command(),
           study_report_command(),
           study_simulate_command(),
           study_targets_command(),
           version_command(
               "Show the versions of mien and its libraries, including those of the web server",
               {{"libarchive", archive_library()},
                {"Boost", http_library()},
                {"SQLite", database_library()}}),
           study_withdraw_command(),
           study_words_command()},
      .notes =
          "Examples:\n"
          "  mien study design emotion-study -o plans.csv       orders of trials for participants\n"
          "  mien study export emotion-study -o questionnaire   a questionnaire for a web server\n"
          "  mien study report answers.csv my.yaml -o results   statistics and figures"};
}

}  // namespace mien::pipeline
