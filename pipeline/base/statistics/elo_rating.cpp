#include "pipeline/base/statistics/elo_rating.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

namespace {

constexpr double first_rating = 1500.0;
constexpr double rating_step = 32.0;
constexpr double rating_scale = 400.0;

struct SingleComparison {
  std::size_t first;
  std::size_t second;
  double result;  ///< of `first`: 1 won, ½ tie, 0 lost
};

std::vector<SingleComparison> single_comparisons(const std::vector<PairCount>& counts) {
  std::vector<SingleComparison> all;
  for (const PairCount& count : counts)
    for (const auto& [number, result] :
         {std::pair(count.first_wins, 1.0), std::pair(count.ties, 0.5),
          std::pair(count.second_wins, 0.0)})
      for (int i = 0; i < std::lround(number); ++i)
        all.push_back({count.first, count.second, result});
  return all;
}

/// Shuffles (Fisher and Yates 1938).
void shuffle(std::vector<SingleComparison>& all, std::uint64_t seed, int order) {
  for (std::size_t i = all.size(); i > 1; --i) {
    const double drawn = uniform(seed, fmt::format("order {} place {}", order, i));
    std::swap(all[i - 1], all[static_cast<std::size_t>(drawn * static_cast<double>(i))]);
  }
}

std::vector<double> rated(const std::vector<SingleComparison>& all, std::size_t stimuli) {
  std::vector<double> ratings(stimuli, first_rating);
  for (const SingleComparison& one : all) {
    const double ahead = ratings[one.second] - ratings[one.first];
    const double expected = 1.0 / (1.0 + std::pow(10.0, ahead / rating_scale));
    ratings[one.first] += rating_step * (one.result - expected);
    ratings[one.second] -= rating_step * (one.result - expected);
  }
  return ratings;
}

}  // namespace

std::vector<EloRating> elo_ratings(const std::vector<PairCount>& counts, std::size_t stimuli,
                                   std::uint64_t seed, int orders) {
  std::vector<SingleComparison> all = single_comparisons(counts);
  std::vector<bool> is_compared(stimuli, false);
  for (const SingleComparison& one : all) is_compared[one.first] = is_compared[one.second] = true;
  std::vector<std::vector<double>> of_orders;
  for (int order = 0; order < orders; ++order) {
    shuffle(all, seed, order);
    of_orders.push_back(rated(all, stimuli));
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<EloRating> ratings(stimuli, {none, none});
  for (std::size_t i = 0; i < stimuli; ++i) {
    if (!is_compared[i]) continue;
    double sum = 0.0;
    double squares = 0.0;
    for (const std::vector<double>& one : of_orders) sum += one[i];
    const double mean = sum / orders;
    for (const std::vector<double>& one : of_orders) squares += (one[i] - mean) * (one[i] - mean);
    ratings[i] = {mean, std::sqrt(squares / (orders - 1))};
  }
  return ratings;
}

}  // namespace mien::pipeline
