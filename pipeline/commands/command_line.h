#pragma once

#include "pipeline/commands/cli.h"

namespace mien::pipeline {

/// Runs what the words of a command line ask of a program; never throws. Faults of the input are
/// told on `err` with exit code 2, failures of the machine with 1.
int run_command_line(const Command& program, int argc, const char* const* argv,
                     const Console& console);

}  // namespace mien::pipeline
