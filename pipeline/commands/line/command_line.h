#pragma once

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// Runs what the words of a command line ask of a program; never throws. Faults of the input are
/// told on `err` with exit code 2, failures of the machine with 1. The word --commands alone, which
/// no help lists, tells another program what this one has.
int run_command_line(const Command& program, int argc, const char* const* argv,
                     const Console& console);

}  // namespace mien::pipeline
