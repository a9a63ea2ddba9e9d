#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/base/statistics/bradley_terry.h"

namespace mien::pipeline {

/// A sum of worths times weights: one weight for each stimulus, with a sum of 0.
using WorthWeights = std::vector<double>;

/// What resampled participants say about a sum of weighted worths.
struct ResampledContrast {
  Interval95 ends;
  double error;  ///< standard deviation over the resamples; NaN if `ends` are
};

/// 95 % intervals of worths that hold if participants, not answers, are independent of each other.
struct WorthBootstrap {
  std::vector<Interval95> worth;             ///< of each stimulus
  std::vector<ResampledContrast> contrasts;  ///< of each sum of weighted worths
  Interval95 order;                          ///< of the order effect
  int resamples = 0;
  /// Number of resamples in which not all worths are finite and comparable.
  int without_estimate = 0;
};

/// Intervals from resampled participants: each resample consists of as many participants as there
/// are, drawn with replacement, with all of their comparisons (Efron and Tibshirani 1993). The ends
/// are percentiles, expanded for the number of participants (Hesterberg 2015), as plain percentiles
/// are too narrow for few. `people` has the comparisons of each participant, at least two.
///
/// A resample in which not all of the stimuli have comparable finite worths counts as below all
/// others for the lower ends and above all others for the upper ends. If there are so many of
/// them that an end would be infinite, it is NaN. The draws depend only on `seed`.
WorthBootstrap worth_bootstrap(const std::vector<std::vector<PairCount>>& people,
                               std::size_t stimuli, OrderEffect order, std::uint64_t seed,
                               int resamples = 999,
                               const std::vector<WorthWeights>& contrasts = {});

}  // namespace mien::pipeline
