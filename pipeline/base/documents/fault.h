#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"

namespace mien::pipeline {

/// One mistake in the user's files or command-line options, or a warning about them.
struct Fault {
  Place place;
  std::string path;    ///< "stimuli[2].adjectives.quicknes"; empty for the file as a whole
  std::string wrong;   ///< "unknown parameter"
  std::string remedy;  ///< "did you mean \"quickness\"?"
};

/// "file:line:column: path.to.key: what is wrong; how to fix it". Text from the file is escaped as
/// in motion/text/excerpt.h; long paths and sentences are shortened.
std::string to_string(const Fault& fault);

/// Maximum number of faults that are listed individually.
inline constexpr std::size_t most_listed_faults = 20;

/// A line for each of the first most_listed_faults faults, prefixed with `beginning`, followed by a
/// line such as "and 3 more" if there are more. There is no line end after the last line.
std::string fault_lines(const std::vector<Fault>& faults, std::string_view beginning = "");

/// Sorts faults by position in the file and drops repetitions.
std::vector<Fault> in_reading_order(std::vector<Fault> faults);

/// Thrown for one or more faults; `what()` is their fault_lines. The command line returns exit code
/// 2 for it.
class Faults : public Error {
 public:
  /// `faults` must not be empty.
  explicit Faults(std::vector<Fault> faults);

  const std::vector<Fault>& list() const { return faults_; }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::vector<Fault> faults_;
  std::string text_;
};

/// Message of a failure for the user: its `what()` or, for std::bad_alloc and std::length_error, a
/// sentence that memory is insufficient, with a remedy.
std::string failure_text(const std::exception& failure);

}  // namespace mien::pipeline
