#include "pipeline/commands/study/study.h"

#include <string>

#include "pipeline/commands/line/other_programs.h"
#include "pipeline/commands/line/program.h"
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

std::vector<CommandOption> subject_options(StudySubject& subject) {
  return {
      option("--examples", &subject.examples, std::string("Examples: a manifest, ") + examples_help)
          .required(),
      option("--ratings", &subject.ratings,
             "Answers (CSV) (default: those of the manifest or built-in set)"),
      option("--scales", &subject.scales,
             "Scales file (YAML) (default: that of the manifest, or the 41 adjective pairs)")};
}

Command study_command() {
  return {
      .name = study_program.command,
      .summary = study_program.summary,
      .commands = {
          study_analyze_command(), study_design_command(), study_evaluate_command(),
          study_export_command(), study_features_command(), study_interfaces_command(),
          study_methods_command(), study_predict_command(), scales_command(), study_serve_command(),
          study_report_command(), study_simulate_command(), study_targets_command(),
          version_command("Show the versions of mien, its libraries and those that serve pages",
                          {{"libarchive", archive_library()},
                           {"Boost", http_library()},
                           {"SQLite", database_library()}}),
          study_words_command()}};
}

}  // namespace mien::pipeline
