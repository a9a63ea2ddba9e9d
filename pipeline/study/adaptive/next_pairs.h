#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/pair_posterior.h"

namespace mien::pipeline {

/// A pair that can be asked. Stimuli are numbered from 0.
struct StimulusPair {
  std::size_t first = 0;
  std::size_t second = 0;

  friend bool operator==(const StimulusPair&, const StimulusPair&) = default;
};

/// The comparisons so far with respect to one item, such as a scale.
struct ComparedItem {
  std::string id;
  std::vector<PairCount> counts;
};

struct NextPairOptions {
  std::size_t pairs = 12;
  double answers = 12.0;  ///< expected number of answers to each pair, above 0
};

/// A pair to ask next, with what is expected of its answers once the pairs before it are answered.
struct NextPair {
  std::size_t pair = 0;  ///< number among those that can be asked
  /// Share of what is unknown that its answers would remove (mean over the items).
  double gain = 0.0;
  std::vector<double> first_chosen;  ///< by item: probability that the first stimulus is chosen
};

struct NextPairs {
  std::vector<NextPair> pairs;  ///< in the order of choice
  /// By item: standard deviation of the worths about their mean (PairPosterior::deviation), now
  /// and, as expected, once the pairs are answered.
  std::vector<double> known_now, known_then;
  std::vector<PairPosterior> known;  ///< by item, now
};

/// Chooses the pairs whose answers tell the most about the worths of the stimuli (pair_posterior.h)
/// with respect to all items: one after the other, each the one whose answers would lower the
/// variance of the worths most, summed over the stimuli and, as shares of the item's present sum,
/// over the items, as films are chosen (next_films.h). After each choice its answers are taken to
/// be as expected. Of pairs that are equal to within rounding, the first is chosen. Fewer are
/// chosen if there are no more. Requires an item and a pair.
///
/// In simulated worlds, the errors of worths were larger if pairs were chosen by the mutual
/// information of an answer and the worths, which prefers the least known stimuli.
NextPairs next_pairs(const std::vector<StimulusPair>& possible,
                     const std::vector<ComparedItem>& items, std::size_t stimuli,
                     const NextPairOptions& options);

}  // namespace mien::pipeline
