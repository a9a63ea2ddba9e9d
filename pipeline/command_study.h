#pragma once

#include "pipeline/cli.h"

namespace mien::pipeline {

// Subcommands of `mien study`, one a source file; each adds itself to `study`.
void add_study_analyze_command(CLI::App& study, Command& chosen);
void add_study_evaluate_command(CLI::App& study, Command& chosen);
void add_study_features_command(CLI::App& study, Command& chosen);
void add_study_interfaces_command(CLI::App& study, Command& chosen);
void add_study_predict_command(CLI::App& study, Command& chosen);
void add_study_targets_command(CLI::App& study, Command& chosen);
void add_study_words_command(CLI::App& study, Command& chosen);

}  // namespace mien::pipeline
