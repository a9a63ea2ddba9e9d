#pragma once

#include <ostream>
#include <stop_token>

#include "pipeline/commands/line/command.h"

namespace mien::pipeline {

inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_interrupted = 130;

struct ExitCode {
  int code;
  const char* meaning;
};
inline constexpr ExitCode exit_codes[] = {{exit_done, "done"},
                                          {exit_failed, "failed"},
                                          {exit_bad_input, "bad input"},
                                          {exit_interrupted, "interrupted"}};

/// The output streams and stop token of a command.
struct Console {
  std::ostream& out;     ///< results
  std::ostream& err;     ///< progress and error messages
  bool err_is_terminal;  ///< if so, progress bars are shown
  std::stop_token stop;  ///< requested by Ctrl-C or SIGTERM
};

}  // namespace mien::pipeline
