#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// What `mien` and the programs beside it are: their commands, under one name, with one help.
Command program_of(std::vector<Command> commands);

/// The `main` of each of them. Words that ask for a command of another program become that program.
int run_program(int argc, char** argv, const std::function<Command()>& program);

/// Runs what the words of a command line ask of a program; never throws. Faults of the input are
/// told on `err` with exit code 2, failures of the machine with 1. The word --commands alone, which
/// no help lists, tells another program what this one has.
int run_command_line(const Command& program, int argc, const char* const* argv,
                     const Console& console);

/// `version` of a program: its own version, the libraries that have a part in artifacts' bytes, and
/// `more` that this program alone has.
Command version_command(std::string summary, std::vector<std::pair<std::string, std::string>> more);

}  // namespace mien::pipeline
