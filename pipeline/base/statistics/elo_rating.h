#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/base/statistics/pair_counts.h"

namespace mien::pipeline {

/// The rating of a stimulus by Elo's method, over several random orders of the comparisons.
struct EloRating {
  double mean;
  /// Standard deviation (n − 1) over the orders: how much the rating depends on the order.
  double deviation;
};

/// Elo's ratings (1978): all stimuli begin with 1500; after each comparison the winner gains 32·(1
/// − expected) points and the loser loses as many, where 1/(1 + 10^((other − own)/400)) is the
/// expected result, and a tie counts as half a win. As the result depends on the order of the
/// comparisons, which has no meaning here, it is averaged over random orders, determined by `seed`.
/// A view of the same counts as bradley_terry for readers used to such ratings: there are no
/// intervals and no tests. Numbers of outcomes must be whole. NaN for a stimulus without
/// comparisons.
std::vector<EloRating> elo_ratings(const std::vector<PairCount>& counts, std::size_t stimuli,
                                   std::uint64_t seed, int orders = 100);

}  // namespace mien::pipeline
