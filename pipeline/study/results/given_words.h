#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// The frequency of a word among free-text answers about a stimulus.
struct GivenWord {
  std::string stimulus;
  std::string item;
  std::string word;  ///< in lower case, trimmed
  int people = 0;    ///< number of participants who used it
  int asked = 0;     ///< number of participants with any word for this stimulus and item
};

/// Splits free-text answers at commas, semicolons and line breaks (, ; 、 ， ； ) and counts each
/// word once per participant and stimulus. Sorted by stimulus in the order of the manifest, item,
/// falling frequency, then alphabetically.
std::vector<GivenWord> given_words_of(const Gathered& gathered);

}  // namespace mien::pipeline
