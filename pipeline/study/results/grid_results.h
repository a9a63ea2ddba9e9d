#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/bradley_terry.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

/// What the stimuli of grid trials compare: stimuli with equal levels of all factors whose levels
/// differ within a set; if the stimuli have no such factors, each is a condition of its own.
struct GridCondition {
  std::string name;  ///< levels, "captured", or the id of the stimulus
  std::string role;  ///< reference or anchor, if all of its stimuli are; otherwise empty
};

/// Ratings of a condition. Each participant contributes the mean of all own ratings.
struct GridMean {
  std::size_t condition = 0;  ///< index into GridResults::conditions
  int people = 0;
  int answers = 0;
  double mean = 0.0;       ///< of the participants' means
  double deviation = 0.0;  ///< standard deviation (n − 1) of these; NaN for one participant
  Interval95 ends;         ///< interval of the mean (Student); NaN for one participant
};

/// A comparison of two conditions. Each participant contributes the mean, over the sets in which
/// both were rated, of the difference.
struct GridDifference {
  std::size_t one = 0;  ///< index into GridResults::conditions
  std::size_t other = 0;
  WithinParticipants within;
  /// p values corrected over all pairs of conditions.
  double paired_adjusted = 1.0;
  double wilcoxon_adjusted = 1.0;
};

struct GridResults {
  std::vector<GridCondition> conditions;    ///< in the order of the manifest
  std::vector<GridMean> means;              ///< of the conditions that were rated
  std::vector<GridDifference> differences;  ///< of those that a participant rated in the same set
};

/// The results of grid trials; empty for other trials.
GridResults grid_results(const AnswerSet& answer_set);

}  // namespace mien::pipeline
