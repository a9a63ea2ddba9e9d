#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/bradley_terry.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Counts of best–worst answers about one stimulus.
struct BestWorstScore {
  std::string scale;  ///< id
  std::size_t stimulus = 0;
  int shown = 0;  ///< number of answered sets with the stimulus
  int best = 0;   ///< of these, those in which it was best, and
  int worst = 0;  ///< those in which it was worst
  int people = 0;
  /// Interval of the mean of the participants' scores (Student), for which participants, not
  /// answers, are independent; NaN with fewer than two participants.
  Interval95 ends;

  /// (best − worst) / shown, from −1 to 1.
  double score() const { return 1.0 * (best - worst) / shown; }
};

/// The preferences that the answer about a set implies: the best one is preferred to all others,
/// and all others to the worst one; of a set of k stimuli 2k − 3 preferences.
std::vector<AnalysedPreference> implied_preferences(const AnalysedSet& set);

/// The scores of all stimuli by scale, in the order of the manifest. Empty without sets.
std::vector<BestWorstScore> best_worst_scores(const AnswerSet& answer_set);

}  // namespace mien::pipeline
