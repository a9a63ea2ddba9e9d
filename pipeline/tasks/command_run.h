#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace mien::pipeline {

/// Exit status and output of a system command.
struct CommandResult {
  int code = 0;             ///< exit code, or 128 + signal number
  bool is_missing = false;  ///< the program was not found or is not executable
  bool timed_out = false;   ///< it exceeded the time limit and was killed
  std::string output;       ///< standard output
  std::string errors;       ///< standard error

  bool succeeded() const { return code == 0 && !is_missing && !timed_out; }
};

/// Runs a program found through PATH with these arguments, without a shell and with empty standard
/// input. The program is killed after `limit`. Throws std::system_error if no process can be
/// started.
CommandResult run_command(const std::vector<std::string>& words, std::chrono::milliseconds limit);

}  // namespace mien::pipeline
