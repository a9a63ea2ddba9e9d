#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// The top-level command of `mien` and its other programs, with a common name and help.
Command program_of(std::vector<Command> commands);

/// The `main` of each program. Executes another program if the command belongs to it.
int run_program(int argc, char** argv, const std::function<Command()>& program);

/// Runs a command line; never throws. Faults of the input are reported on `err` with exit code 2,
/// other failures with 1. The undocumented option --commands prints this program's commands for
/// another program.
int run_command_line(const Command& program, int argc, const char* const* argv,
                     const Console& console);

/// The command `version`: the program's version, the libraries that affect artifacts' bytes, and
/// `more`, those of this program only.
Command version_command(std::string summary, std::vector<std::pair<std::string, std::string>> more);

}  // namespace mien::pipeline
