#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/mark.h>

#include "motion/error.h"

namespace mien::pipeline {

/// Turns the YAML parser's marks, whose columns count bytes, into places, whose columns count
/// characters. Text and file name must outlive this object. Not thread-safe.
class YamlPlaces {
 public:
  YamlPlaces(std::string_view text, const std::string& file);

  Place at(const YAML::Mark& mark) const;

  /// A line, counted from 1, including its line end; empty when there is no such line.
  std::string_view line(int number) const;

  /// The text from the mark on.
  std::string_view text_from(const YAML::Mark& mark) const;

 private:
  std::string_view text_;
  const std::string& file_;
  std::vector<std::string_view> lines_;

  /// Cache of the last position, because marks arrive in text order and a line may be very long.
  struct Last {
    int line = -1;
    std::size_t bytes = 0;
    std::size_t characters = 0;
  };
  mutable Last last_;
};

}  // namespace mien::pipeline
