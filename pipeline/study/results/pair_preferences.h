#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Counts of choices between two stimuli for one item.
struct PreferenceCount {
  std::string item;
  std::size_t one = 0;  ///< the stimulus that is earlier in the manifest
  std::size_t other = 0;
  int trials = 0;
  int for_one = 0;   ///< number of choices of `one`
  int ties = 0;      ///< number of answers that prefer neither; not among `trials`
  double low = 0.0;  ///< Wilson's 95 % interval of the share of `one`
  double high = 1.0;
  double p = 1.0;         ///< p of an exact two-sided binomial test of `for_one` against one half
  double adjusted = 1.0;  ///< p adjusted over all pairs of stimuli and all items
};

/// The question about a pair in words: "more happy" asks which of the two stimuli is closer to the
/// high end of the scale. If no scale has the id `item`, returns `item`.
std::string pair_question(const AnswerSet& answer_set, const std::string& item);

/// Preferences for all pairs of stimuli about which there are choices, sorted by item, then by pair
/// in the order of the manifest. Ties are no choices. None of answers about sets: the preferences
/// that these imply depend on each other.
std::vector<PreferenceCount> preferences_of(const AnswerSet& answer_set);

}  // namespace mien::pipeline
