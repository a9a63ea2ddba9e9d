#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace mien::pipeline {

/// How a command of the system ended and what it said.
struct CommandEnd {
  int code = 0;             ///< exit code, or 128 + the signal that ended it
  bool is_missing = false;  ///< there is no such program
  bool timed_out = false;   ///< it was killed; nothing is known of what it did
  std::string output;       ///< standard output
  std::string errors;       ///< standard error

  bool is_done() const { return code == 0 && !is_missing && !timed_out; }
};

/// Runs a program that PATH leads to, with these arguments as they are: no shell reads them. Its
/// standard input is empty. What takes longer than `limit` is killed. Throws std::system_error when
/// the machine cannot start any program.
CommandEnd run_command(const std::vector<std::string>& words, std::chrono::milliseconds limit);

}  // namespace mien::pipeline
