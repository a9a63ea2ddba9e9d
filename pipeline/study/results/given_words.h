#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// How often a word was given for a stimulus.
struct GivenWord {
  std::string stimulus;
  std::string item;
  std::string word;  ///< in small letters, without spaces about it
  int people = 0;    ///< who gave it
  int asked = 0;     ///< who gave any word for this stimulus and item
};

/// Answers in words, divided at commas, semicolons and ends of lines (, ; 、 ， ； ), each word
/// once a person and stimulus. In the order of the manifest's stimuli, then of items, then the most
/// frequent first, then by the alphabet.
std::vector<GivenWord> given_words_of(const Gathered& gathered);

}  // namespace mien::pipeline
