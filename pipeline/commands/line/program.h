#pragma once

#include <functional>

#include "pipeline/commands/line/console.h"

namespace mien::pipeline {

/// What `mien` and the programs beside it are: their commands, under one name, with one help.
Command program_of(std::vector<Command> commands);

/// The `main` of each of them. Words that ask for a command of another program become that program.
int run_program(int argc, char** argv, const std::function<Command()>& program);

}  // namespace mien::pipeline
