#pragma once

#include "pipeline/commands/cli.h"
#include "pipeline/commands/study/study_subject.h"

namespace mien::pipeline {

/// The options --examples (required), --ratings and --scales, which say what a command is about.
void add_subject_options(CLI::App& command, StudySubject& subject);

// Subcommands of `mien study`, one a source file; each adds itself to `study`.
void add_study_analyze_command(CLI::App& study, Command& chosen);
void add_study_design_command(CLI::App& study, Command& chosen);
void add_study_evaluate_command(CLI::App& study, Command& chosen);
void add_study_export_command(CLI::App& study, Command& chosen);
void add_study_features_command(CLI::App& study, Command& chosen);
void add_study_interfaces_command(CLI::App& study, Command& chosen);
void add_study_methods_command(CLI::App& study, Command& chosen);
void add_study_predict_command(CLI::App& study, Command& chosen);
void add_study_serve_command(CLI::App& study, Command& chosen);
void add_study_report_command(CLI::App& study, Command& chosen);
void add_study_simulate_command(CLI::App& study, Command& chosen);
void add_study_targets_command(CLI::App& study, Command& chosen);
void add_study_words_command(CLI::App& study, Command& chosen);

}  // namespace mien::pipeline
