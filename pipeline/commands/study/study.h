#pragma once

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/study/study_subject.h"

namespace mien::pipeline {

/// The options --examples (required), --ratings and --scales, which say what a command is about.
std::vector<CommandOption> subject_options(StudySubject& subject);

Command studio_command();
Command study_command();

// Subcommands of `mien study`, one a source file.
Command study_analyze_command();
Command study_design_command();
Command study_evaluate_command();
Command study_export_command();
Command study_features_command();
Command study_interfaces_command();
Command study_methods_command();
Command study_predict_command();
Command study_serve_command();
Command study_report_command();
Command study_simulate_command();
Command study_targets_command();
Command study_words_command();

}  // namespace mien::pipeline
