#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/rating_spread.h"

namespace mien::pipeline {

/// What a power estimate simulates: ratings that are sums of a participant's, a stimulus's and a
/// residual part, by the shares that the design deals out, and a paired t test over the
/// participants of two things they saw.
struct PowerQuestion {
  RatingSpread spread;
  double difference = 0.5;  ///< true, in points of the scale
  double wanted = 0.8;      ///< power
  double alpha = 0.05;      ///< of the two-sided test
  int studies = 4000;       ///< simulated for each number of participants
  int most_participants = 1000;
  std::uint64_t seed = 0;
  /// Compared are two stimuli, any two of the design; or, with a factor, two of its levels: each
  /// participant's mean over what he saw of them, stimuli being drawn anew for every study.
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
  int participants = 0;         ///< planned
  SimulatedShare power;         ///< with so many
  SimulatedShare false_alarms;  ///< found where there is no difference, with so many
  double usable = 0.0;          ///< participants who saw both, on the average
  int needed = 0;       ///< least number that finds it as often as wanted; 0: more than the most
  int needed_low = 0;   ///< by the upper end of the simulation's interval
  int needed_high = 0;  ///< by the lower end; 0: more than the most
};

/// Deterministic in the seed. Every number of participants is tried with the same simulated people.
/// Throws Error for a factor or level that the stimuli do not have, and for designs in which nobody
/// sees two stimuli.
PowerEstimate estimate_power(const Manifest& manifest, const PowerQuestion& question);

/// Whether differences among stimuli of the same level make the test find what is not there more
/// often than its level allows, beyond the simulation's error. Its power is no power then.
bool is_test_misled(const PowerQuestion& question, const PowerEstimate& estimate);

/// Plain sentences: what was simulated, what came out, with which error. A test that is misled is
/// told no number of participants.
std::vector<std::string> power_sentences(const PowerQuestion& question,
                                         const PowerEstimate& estimate);

}  // namespace mien::pipeline
