#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace mien::test {

/// Exit status and output of a program.
struct Ended {
  int code = 0;        ///< exit code, or 128 + signal
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// A fresh folder that is removed with the object.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);

/// A child process that runs in the background.
class Running {
 public:
  /// Any program that PATH leads to, with its arguments.
  explicit Running(const std::vector<std::string>& words);
  /// Kills it if it is still running.
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool is_running();
  /// Sends a signal; does nothing if the program has ended.
  void send(int signal);
  /// Waits until it has ended; kills it after `seconds`.
  Ended wait(double seconds = 3600.0);

 private:
  bool has_ended(int flags);

  Scratch said_;
  pid_t process_ = -1;
  std::optional<int> code_;
};

/// Runs the mien that was built beside the tests. `kill_after_seconds` ≥ 0 sends the signal then,
/// if it is still running.
Ended run_mien(const std::vector<std::string>& arguments, double kill_after_seconds = -1.0,
               int signal = 9);

/// Runs any program that PATH leads to.
Ended run_program(const std::vector<std::string>& words, double kill_after_seconds = -1.0,
                  int signal = 9);

/// Runs a program and returns its output. Throws std::runtime_error if its exit code is not 0.
std::string must_run(const std::vector<std::string>& words);

/// The words that run the mien that was built beside the tests.
std::vector<std::string> mien_with(const std::vector<std::string>& arguments);

/// Time of a monotonic clock, seconds.
double seconds_now();

void pause_for(double seconds);

}  // namespace mien::test
