#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"

namespace mien::pipeline {

/// One thing that is wrong in a file that the user wrote.
struct Fault {
  Place place;
  std::string path;    ///< "stimuli[2].adjectives.quicknes"; empty for the file as a whole
  std::string wrong;   ///< "unknown parameter"
  std::string remedy;  ///< "did you mean \"quickness\"?"
};

/// "file:line:column: path.to.key: what is wrong; how to mend it", in which foreign text is written
/// out as in motion/text/excerpt.h, and a path or sentence of any length is cut.
std::string to_string(const Fault& fault);

/// Most faults of one kind that are told one by one.
inline constexpr std::size_t most_told_faults = 20;

/// A line for each of the first twenty, with `beginning` before it, and "and 3 more" after these if
/// there are. Without a line end after the last.
std::string fault_lines(const std::vector<Fault>& faults, std::string_view beginning = "");

/// Orders faults as a reader of the file meets them and drops repetitions.
std::vector<Fault> in_reading_order(std::vector<Fault> faults);

/// Several faults at once; `what()` has a line for each of the first twenty. The command line turns
/// it into exit code 2.
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

/// What a failure says to people: its own words, or that the memory does not suffice and what
/// helps.
std::string failure_text(const std::exception& failure);

}  // namespace mien::pipeline
