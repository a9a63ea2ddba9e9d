#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/statistics/correlation.h"
#include "pipeline/study/results/gathered_answers.h"

namespace mien::pipeline {

/// How two ends of scales go together: the scales are split at their middle, an answer a becoming
/// max(−a, 0) at the low end and max(a, 0) at the high end, and the showings (one person, one
/// stimulus) are correlated in which both scales were answered.
struct EndCorrelation {
  std::size_t one = 0;  ///< of the ends (confusion.h), below `other`
  std::size_t other = 0;
  bool same_scale = false;  ///< the two ends of one scale: negative by its making
  Correlation correlation;
  double adjusted = 1.0;  ///< p corrected over the pairs of different scales
};

/// All pairs of ends. The thesis marks |r| above 0.3 and above 0.5.
std::vector<EndCorrelation> end_correlations(const Gathered& gathered);

}  // namespace mien::pipeline
