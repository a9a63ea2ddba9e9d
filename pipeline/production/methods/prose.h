#pragma once

#include <limits>
#include <string>
#include <vector>

namespace mien::pipeline {

// Words and numbers in the form in which sentences use them.

using Names = std::vector<std::string>;

/// "1 stimulus was", "3 stimuli were"
std::string count_of(std::size_t count, const std::string& one, const std::string& many);

/// "a, b and c"
std::string listed(const Names& names);

/// The sentence with a whole number at its beginning in words, as is usual in papers: "Two stimuli
/// were"; from 100 on "A total of 120 stimuli were".
std::string sentence_start(const std::string& sentence);

void add_once(Names& names, const std::string& name);

/// Minimum, maximum and mean of a series of numbers.
struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  double sum = 0.0;
  int count = 0;

  void add(double value);
  double mean() const { return sum / count; }
};

/// Returns "from 1.20 to 1.40 s", or "1.20 s" if all values are equal after rounding. `unit` begins
/// with a space or is empty.
std::string range_text(const Range& range, int digits, const std::string& unit);

/// Returns "from 1.20 to 1.40 s (mean 1.31 s)", or "1.20 s" if all values are equal after rounding.
/// `unit` begins with a space or is empty.
std::string with_mean(const Range& range, int digits, const std::string& unit);

}  // namespace mien::pipeline
