#include "pipeline/base/statistics/worth_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

namespace {

/// Comparisons of one participant, as places in the list of all pairs.
struct PlacedCount {
  std::size_t pair;
  PairCount count;
};

/// All pairs that occur, without outcomes, and the participants' comparisons of them.
struct PlacedCounts {
  std::vector<PairCount> pairs;
  std::vector<std::vector<PlacedCount>> people;
};

PlacedCounts placed(const std::vector<std::vector<PairCount>>& people) {
  PlacedCounts result;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> places;
  for (const std::vector<PairCount>& own : people) {
    std::vector<PlacedCount>& all = result.people.emplace_back();
    for (const PairCount& count : own) {
      const auto [place, is_new] =
          places.try_emplace({count.first, count.second}, result.pairs.size());
      if (is_new) result.pairs.push_back({count.first, count.second});
      all.push_back({place->second, count});
    }
  }
  return result;
}

std::vector<PairCount> resampled(const PlacedCounts& all, std::uint64_t seed, int resample) {
  std::vector<PairCount> counts = all.pairs;
  const std::size_t people = all.people.size();
  for (std::size_t i = 0; i < people; ++i) {
    const double drawn = uniform(seed, fmt::format("resample {} participant {}", resample, i));
    const auto person = static_cast<std::size_t>(drawn * static_cast<double>(people));
    for (const PlacedCount& own : all.people[std::min(person, people - 1)]) {
      PairCount& count = counts[own.pair];
      count.first_wins += own.count.first_wins;
      count.second_wins += own.count.second_wins;
      count.ties += own.count.ties;
    }
  }
  return counts;
}

bool has_all_worths(const BradleyTerry& fit) {
  return fit.is_finite && !fit.groups.sizes.empty() && fit.groups.sizes.size() == 1;
}

/// The proportion of resamples below each end for n participants: 2.5 % for many, and less for few,
/// so that intervals of means are as wide as Student's (Hesterberg 2015, expanded percentiles).
double tail_share(std::size_t people) {
  if (people < 2) return 0.0;
  const auto n = static_cast<double>(people);
  const double t = quantile(boost::math::students_t(n - 1.0), 0.975);
  return cdf(boost::math::normal(), -std::sqrt(n / (n - 1.0)) * t);
}

/// The values at these proportions from either end. Those missing from `values` count as smaller
/// and as larger than all others.
Interval95 percentiles(std::vector<double> values, int resamples, double share) {
  Interval95 interval{std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::quiet_NaN()};
  const auto missing = static_cast<std::ptrdiff_t>(resamples) - std::ssize(values);
  const auto rank = static_cast<std::ptrdiff_t>((resamples + 1) * share) - 1 - missing;
  if (rank < 0 || rank >= std::ssize(values)) return interval;
  std::ranges::sort(values);
  return {values[static_cast<std::size_t>(rank)],
          values[values.size() - 1 - static_cast<std::size_t>(rank)]};
}

double weighted_sum(const WorthWeights& weights, const std::vector<double>& worths) {
  return std::inner_product(weights.begin(), weights.end(), worths.begin(), 0.0);
}

/// n − 1 in the denominator.
double resampled_error(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (n - 1.0));
}

}  // namespace

WorthBootstrap worth_bootstrap(const std::vector<std::vector<PairCount>>& people,
                               std::size_t stimuli, OrderEffect order, std::uint64_t seed,
                               int resamples, const std::vector<WorthWeights>& contrasts) {
  const PlacedCounts all = placed(people);
  std::vector<std::vector<double>> worths(stimuli);
  std::vector<std::vector<double>> sums(contrasts.size());
  std::vector<double> orders;
  WorthBootstrap result;
  result.resamples = resamples;
  for (int n = 0; n < resamples; ++n) {
    const BradleyTerry fit = bradley_terry(resampled(all, seed, n), stimuli, order);
    if (!has_all_worths(fit)) {
      ++result.without_estimate;
      continue;
    }
    for (std::size_t i = 0; i < stimuli; ++i) worths[i].push_back(fit.worth[i]);
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i].push_back(weighted_sum(contrasts[i], fit.worth));
    if (order == OrderEffect::estimated) orders.push_back(fit.order);
  }
  const double share = tail_share(people.size());
  for (std::vector<double>& values : worths)
    result.worth.push_back(percentiles(std::move(values), resamples, share));
  for (std::vector<double>& values : sums) {
    const double error = resampled_error(values);
    const Interval95 ends = percentiles(std::move(values), resamples, share);
    result.contrasts.push_back({ends, std::isnan(ends.low) ? ends.low : error});
  }
  result.order = percentiles(std::move(orders), resamples, share);
  return result;
}

}  // namespace mien::pipeline
