#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace mien::pipeline {

/// A one-line message that states the fault of a command line and its remedy. It is about the
/// innermost command and names an unknown option (with the most similar known one), all missing
/// options and arguments, the possible subcommands if one is missing, a superfluous argument, or a
/// missing or invalid value. `fault` was thrown when `app` parsed the command line.
std::string command_line_fault(const CLI::App& app, const CLI::ParseError& fault);

}  // namespace mien::pipeline
