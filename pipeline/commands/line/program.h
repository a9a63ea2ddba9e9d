#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// The top-level command of `mien` or of one of its external programs, with the common name and
/// help.
Command program_of(std::vector<Command> commands);

/// The main function of each program. If another program implements the command, executes that.
int run_program(int argc, char** argv, const std::function<Command()>& program);

/// Runs a command line and returns its exit code; never throws. Errors are printed on
/// `console.err`; the code is 2 for invalid input, 130 if interrupted, and 1 for other failures.
/// The undocumented option --commands prints this program's commands as JSON for another program.
int run_command_line(const Command& program, int argc, const char* const* argv,
                     const Console& console);

/// The command `version`, which prints the versions of the program, of the libraries that affect
/// the bytes of artifacts, and of the libraries in `more`, which only this program uses.
Command version_command(std::string summary, std::vector<std::pair<std::string, std::string>> more);

}  // namespace mien::pipeline
