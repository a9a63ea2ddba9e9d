#pragma once

#include <functional>
#include <ostream>
#include <stop_token>
#include <string>

namespace CLI {
class App;
}

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

/// What a command works with.
struct Console {
  std::ostream& out;     ///< results
  std::ostream& err;     ///< progress and faults
  bool err_is_terminal;  ///< a progress bar makes sense
  std::stop_token stop;  ///< requested by Ctrl-C
};

/// A command that was chosen on the command line; returns the exit code.
using Command = std::function<int(const Console&)>;

/// Each adds its subcommand to `app` and sets `chosen` when it is the one that was typed.
void add_check_command(CLI::App& app, Command& chosen);
void add_clean_command(CLI::App& app, Command& chosen);
void add_completion_command(CLI::App& app, Command& chosen);
void add_farm_command(CLI::App& app, Command& chosen);
void add_man_command(CLI::App& app, Command& chosen);
void add_manifests_command(CLI::App& app, Command& chosen);
void add_pack_command(CLI::App& app, Command& chosen);
void add_plan_command(CLI::App& app, Command& chosen);
void add_regress_command(CLI::App& app, Command& chosen);
void add_run_command(CLI::App& app, Command& chosen);
void add_render_command(CLI::App& app, Command& chosen);
void add_motion_command(CLI::App& app, Command& chosen);
void add_sets_command(CLI::App& app, Command& chosen);
void add_studio_command(CLI::App& app, Command& chosen);
void add_study_command(CLI::App& app, Command& chosen);
void add_verify_command(CLI::App& app, Command& chosen);
void add_version_command(CLI::App& app, Command& chosen);

/// Runs the program; never throws. Faults of the input are told on `err` with exit code 2, failures
/// of the machine with 1.
int run_command_line(int argc, const char* const* argv, const Console& console);

}  // namespace mien::pipeline
