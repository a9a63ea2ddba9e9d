#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace mien::pipeline {

/// What is wrong with the words of a command line, and how to mend it, in one line: of the command
/// that was meant, all that is missing, an option that it does not have and the one that it may
/// have been, a word too many. `app` has parsed them and thrown `fault`.
std::string command_line_fault(const CLI::App& app, const CLI::ParseError& fault);

}  // namespace mien::pipeline
