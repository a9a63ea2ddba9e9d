#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mien::test {

/// How a program ended and what it said.
struct Ended {
  int code = 0;        ///< exit code, or 128 + signal
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs the mien that was built beside the tests. `kill_after_seconds` ≥ 0 sends SIGKILL then, if
/// it is still running.
Ended run_mien(const std::vector<std::string>& arguments, double kill_after_seconds = -1.0,
               int signal = 9);

/// Runs any program that PATH leads to.
Ended run_program(const std::vector<std::string>& words, double kill_after_seconds = -1.0,
                  int signal = 9);

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

}  // namespace mien::test
