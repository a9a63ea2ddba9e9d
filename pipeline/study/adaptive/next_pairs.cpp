#include "pipeline/study/adaptive/next_pairs.h"

#include <algorithm>

namespace mien::pipeline {

namespace {

/// What is known with respect to an item.
struct ItemKnowledge {
  PairPosterior worths;
  double at_first = 0.0;  ///< sum of the variances before anything is chosen
};

NextPair expected_of(const StimulusPair& asked, const std::vector<ItemKnowledge>& known,
                     double answers, std::size_t number) {
  NextPair pair{.pair = number, .gain = 0.0, .first_chosen = {}};
  for (const ItemKnowledge& item : known) {
    const double gain = expected_gain(item.worths, asked.first, asked.second, answers);
    pair.gain += gain / item.at_first / static_cast<double>(known.size());
  }
  return pair;
}

std::vector<double> deviations_of(const std::vector<ItemKnowledge>& known) {
  std::vector<double> deviations;
  for (const ItemKnowledge& item : known) deviations.push_back(item.worths.deviation());
  return deviations;
}

}  // namespace

NextPairs next_pairs(const std::vector<StimulusPair>& possible,
                     const std::vector<ComparedItem>& items, std::size_t stimuli,
                     const NextPairOptions& options) {
  constexpr double rounding = 1e-12;  // of a share
  std::vector<ItemKnowledge> known;
  NextPairs next;
  for (const ComparedItem& item : items) {
    next.known.push_back(pair_posterior(item.counts, stimuli));
    known.push_back({next.known.back(), next.known.back().variance()});
  }
  next.known_now = deviations_of(known);
  std::vector<bool> is_taken(possible.size());
  while (next.pairs.size() < std::min(options.pairs, possible.size())) {
    NextPair best{.pair = 0, .gain = -1.0, .first_chosen = {}};
    for (std::size_t number = 0; number < possible.size(); ++number) {
      if (is_taken[number]) continue;
      NextPair pair = expected_of(possible[number], known, options.answers, number);
      if (pair.gain > best.gain + rounding) best = std::move(pair);
    }
    is_taken[best.pair] = true;
    const auto& [first, second] = possible[best.pair];
    for (ItemKnowledge& item : known) {
      best.first_chosen.push_back(expected_comparison(item.worths, first, second).first_chosen);
      expect_answers(item.worths, first, second, options.answers);
    }
    next.pairs.push_back(std::move(best));
  }
  next.known_then = deviations_of(known);
  return next;
}

}  // namespace mien::pipeline
