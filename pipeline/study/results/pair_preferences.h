#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Counts of choices between two stimuli.
struct PreferenceCount {
  std::string item;
  std::size_t one = 0;  ///< the earlier one in the manifest
  std::size_t other = 0;
  int trials = 0;
  int for_one = 0;
  double low = 0.0;  ///< Wilson's 95 % interval of the share for one
  double high = 1.0;
  double p = 1.0;  ///< exact binomial test, two-sided, against one half
  double adjusted = 1.0;
};

/// The question about a pair: which is closer to the scale's high end.
std::string pair_question(const AnswerSet& answer_set, const std::string& item);

/// Preferences of all pairs that were shown.
std::vector<PreferenceCount> preferences_of(const AnswerSet& answer_set);

}  // namespace mien::pipeline
