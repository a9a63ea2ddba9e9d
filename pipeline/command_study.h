#pragma once

#include "pipeline/cli.h"

namespace mien::pipeline {

/// Subcommands of `mien study`, one a source file.
void add_study_words_command(CLI::App& study, Command& chosen);

}  // namespace mien::pipeline
