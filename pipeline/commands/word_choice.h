#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/text/nearest_word.h"

namespace mien::pipeline {

/// For `transform` of an option that takes one of these words: a fault names the words.
template <class Enum>
CLI::Validator choice_of(const std::map<std::string, Enum>& words) {
  const auto choose = [words](std::string& given) -> std::string {
    const auto found = words.find(given);
    if (found != words.end()) {
      given = std::to_string(static_cast<int>(found->second));
      return "";
    }
    std::vector<std::string> known;
    for (const auto& [word, value] : words) known.push_back(word);
    if (motion::nearest_word(given, known))
      return fmt::format("\"{}\": {}", given, motion::did_you_mean(given, known));
    return fmt::format("\"{}\" is not one of {}", given, fmt::join(known, ", "));
  };
  return {choose, ""};
}

}  // namespace mien::pipeline
