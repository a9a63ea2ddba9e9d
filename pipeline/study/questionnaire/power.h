#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/rating_spread.h"

namespace mien::pipeline {

/// Settings of a power estimate. Each simulated rating is the sum of a participant effect, a
/// stimulus effect and a residual, for the stimuli that the design assigns to the participant. A
/// paired t-test over participants compares two stimuli or two levels of a factor.
struct PowerOptions {
  RatingSpread spread;
  double difference = 0.5;    ///< true difference, in points of the scale
  double wanted_power = 0.8;  ///< intended power, 0 to 1
  double alpha = 0.05;        ///< significance level of the two-sided test
  int studies = 4000;         ///< number of studies simulated for each number of participants
  int max_participants = 1000;
  std::uint64_t seed = 0;
  /// If empty, two stimuli of the design are compared, drawn anew for each simulated study.
  /// Otherwise two levels of this factor are compared, by each participant's mean over the stimuli
  /// seen at each level; stimulus effects are drawn anew for each simulated study.
  std::string factor;
  std::string level, other_level;
};

/// A share of simulated studies and its 95 % Monte-Carlo interval (Wilson 1927).
struct SimulatedShare {
  double share = 0.0;
  double low = 0.0;
  double high = 1.0;
};

/// The share of successes with Wilson's 95 % interval.
SimulatedShare simulated_share(int successes, int trials);

struct PowerEstimate {
  int participants = 0;            ///< planned number
  SimulatedShare power;            ///< at the planned number
  SimulatedShare false_positives;  ///< at the planned number, without a true difference
  double usable = 0.0;             ///< mean number of participants who saw both stimuli or levels
  int needed = 0;  ///< smallest number with the intended power; 0: more than max_participants
  /// Smallest number for which the upper limit of the power's interval reaches the intended power;
  /// 0: more than max_participants.
  int needed_low = 0;
  /// Smallest number for which the lower limit of the power's interval reaches the intended power;
  /// 0: more than max_participants.
  int needed_high = 0;
};

/// Estimates the power of the test by simulation, and the number of participants needed.
/// Deterministic in the seed. The same simulated participants are used for all numbers of
/// participants. Throws Error for a factor or level that the stimuli do not have, for designs in
/// which no participant sees two stimuli, and for trials that compare pairs.
PowerEstimate estimate_power(const Manifest& manifest, const PowerOptions& options);

/// Whether differences among stimuli of the same level raise the false-positive rate of the test
/// above alpha by more than the Monte-Carlo error. If so, the estimated power is meaningless.
bool is_false_positive_rate_inflated(const PowerOptions& options, const PowerEstimate& estimate);

/// Sentences that describe the simulation and its result with the Monte-Carlo error. The number
/// of participants needed is not stated for a test with an inflated false-positive rate.
std::vector<std::string> power_sentences(const PowerOptions& options,
                                         const PowerEstimate& estimate);

}  // namespace mien::pipeline
