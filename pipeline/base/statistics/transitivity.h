#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pipeline/base/statistics/pair_counts.h"

namespace mien::pipeline {

/// Consistency of one participant who compared each stimulus with each other (Kendall and Babington
/// Smith 1940).
struct CircularTriads {
  int circular = 0;  ///< number of triads in which a is preferred to b, b to c, and c to a
  int most = 0;      ///< greatest possible number for so many stimuli
  double by_chance;  ///< number expected if all answers are given at random
  double zeta;       ///< coefficient of consistence, 1 − circular/most: 1 without circular triads
};

/// The circular triads of a participant. If a pair was compared several times, the majority counts.
/// nullopt with fewer than three stimuli, if a pair was not compared, or if a pair has no majority
/// (ties count for neither).
std::optional<CircularTriads> circular_triads(const std::vector<PairCount>& counts,
                                              std::size_t stimuli);

/// How often the proportions of choices contradict an order of the stimuli. For a triad a, b, c
/// with P(a over b) ≥ ½ and P(b over c) ≥ ½, transitivity demands of P(a over c): weak, at least ½;
/// moderate, at least the smaller of the two; strong, at least the larger of the two.
struct TransitivityViolations {
  int triads = 0;  ///< number of triads in which all three pairs were compared
  int weak = 0;
  int moderate = 0;  ///< includes those that violate the weak form
  int strong = 0;    ///< includes those that violate the moderate form
};

/// Violations of the observed proportions, which also occur by chance; ties count half for either.
/// If several orders of a triad are possible because of proportions of ½, the one with the fewest
/// violations counts.
TransitivityViolations transitivity_violations(const std::vector<PairCount>& counts,
                                               std::size_t stimuli);

}  // namespace mien::pipeline
