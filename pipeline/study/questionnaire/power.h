#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/rating_spread.h"

namespace mien::pipeline {

/// Settings of a power estimate. Simulated ratings are sums of a participant, a stimulus and a
/// residual effect, for the stimuli that the design assigns to each participant; a paired t test
/// over participants compares two stimuli or two levels.
struct PowerOptions {
  RatingSpread spread;
  double difference = 0.5;    ///< true difference, in points of the scale
  double wanted_power = 0.8;  ///< power
  double alpha = 0.05;        ///< of the two-sided test
  int studies = 4000;         ///< simulated for each number of participants
  int max_participants = 1000;
  std::uint64_t seed = 0;
  /// Without a factor, any two stimuli of the design are compared. With one, two of its levels:
  /// each participant's mean over the stimuli seen at each level, with stimulus effects drawn anew
  /// for each simulated study.
  std::string factor;
  std::string level, other_level;
};

/// A share of simulated studies and its 95 % Monte-Carlo interval (Wilson 1927).
struct SimulatedShare {
  double share = 0.0;
  double low = 0.0;
  double high = 1.0;
};

/// Wilson's interval at 95 %.
SimulatedShare simulated_share(int successes, int trials);

struct PowerEstimate {
  int participants = 0;            ///< planned number
  SimulatedShare power;            ///< at the planned number
  SimulatedShare false_positives;  ///< false positives at the planned number
  double usable = 0.0;             ///< mean number of participants who saw both
  int needed = 0;       ///< least number with the wanted power; 0: more than max_participants
  int needed_low = 0;   ///< from the upper limit of the Monte-Carlo interval
  int needed_high = 0;  ///< from the lower limit; 0: more than max_participants
};

/// Estimates the power of the test by simulation, and the number of participants needed.
/// Deterministic in the seed. All numbers of participants use the same simulated participants.
/// Throws Error for a factor or level that the stimuli do not have, and for designs in which no
/// participant sees two stimuli.
PowerEstimate estimate_power(const Manifest& manifest, const PowerOptions& options);

/// Whether differences among stimuli of the same level raise the false-positive rate of the test
/// above alpha, beyond the Monte-Carlo error. Its power is meaningless then.
bool is_false_positive_rate_inflated(const PowerOptions& options, const PowerEstimate& estimate);

/// Sentences on what was simulated and the result with its error. For a test with an inflated
/// false-positive rate no number of participants is given.
std::vector<std::string> power_sentences(const PowerOptions& options,
                                         const PowerEstimate& estimate);

}  // namespace mien::pipeline
