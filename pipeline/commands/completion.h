#pragma once

#include <string>

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

/// The command whose first column lists what an argument may be: "mien sets" for the name of a set.
/// Empty when there is none.
std::string command_that_lists(const CommandPage& page, const CommandOption& argument);

/// Scripts that let a shell complete commands, options, values of options with fixed choices,
/// names of manifests and sets, and files.
std::string bash_completion(const Command& program);
std::string zsh_completion(const Command& program);

}  // namespace mien::pipeline
