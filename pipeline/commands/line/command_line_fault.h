#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace mien::pipeline {

/// One line that states what is wrong with a command line and how to fix it: for the innermost
/// command, all missing options, an unknown option and the most similar one, or a surplus word.
/// `fault` was thrown when `app` parsed the command line.
std::string command_line_fault(const CLI::App& app, const CLI::ParseError& fault);

}  // namespace mien::pipeline
