#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// The frequency of a word among free-text answers about a stimulus.
struct WordFrequency {
  std::string stimulus;
  std::string item;
  std::string word;     ///< trimmed, with letters A to Z in lower case
  int people = 0;       ///< number of participants who used it
  int respondents = 0;  ///< number of participants with any word for this stimulus and item
};

/// Splits free-text answers at commas, semicolons and line breaks (, ; 、 ， ； ) and counts each
/// word once per participant and stimulus. Sorted by stimulus in the order of the manifest, by
/// item, by decreasing frequency, then alphabetically.
std::vector<WordFrequency> word_frequencies_of(const AnswerSet& answer_set);

}  // namespace mien::pipeline
