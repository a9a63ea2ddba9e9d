#include "pipeline/base/statistics/hodges_lehmann.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <boost/math/distributions/normal.hpp>

namespace mien::pipeline {

namespace {

std::vector<double> means_of_pairs(const std::vector<double>& values) {
  std::vector<double> means;
  means.reserve(values.size() * (values.size() + 1) / 2);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = i; k < values.size(); ++k) means.push_back(0.5 * (values[i] + values[k]));
  std::ranges::sort(means);
  return means;
}

/// P(W+ = w) of n differences without ties.
std::vector<double> signed_rank_distribution(std::size_t n) {
  std::vector<double> probability = {1.0};
  for (std::size_t rank = 1; rank <= n; ++rank) {
    std::vector<double> next(probability.size() + rank, 0.0);
    for (std::size_t w = 0; w < probability.size(); ++w) {
      next[w] += 0.5 * probability[w];
      next[w + rank] += 0.5 * probability[w];
    }
    probability = std::move(next);
  }
  return probability;
}

/// How many means lie beyond each end of the interval, and how probable either is.
struct Tail {
  std::size_t beyond = 0;
  double probability = 0.0;
};

constexpr std::size_t most_exact = 300;

/// The first w with P(W+ ≤ w) ≥ α/2 leaves w means beyond, as R's qsignrank does.
Tail exact_tail(std::size_t n, double half_alpha) {
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  Tail tail;
  double at_most = 0.0;
  for (const double p : signed_rank_distribution(n)) {
    if (at_most + p >= half_alpha * (1.0 - rounding)) break;
    at_most += p;
    ++tail.beyond;
  }
  tail.probability = at_most;
  return tail;
}

Tail normal_tail(std::size_t count, double half_alpha) {
  const auto n = static_cast<double>(count);
  const double mean = n * (n + 1.0) / 4.0;
  const double spread = std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0);
  const double z = quantile(boost::math::normal(), half_alpha);
  return {static_cast<std::size_t>(std::max(0.0, std::floor(mean + z * spread))), half_alpha};
}

double median_of_sorted(const std::vector<double>& sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace

HodgesLehmann hodges_lehmann(const std::vector<double>& differences, double confidence) {
  if (differences.empty()) {
    constexpr double not_there = std::numeric_limits<double>::quiet_NaN();
    return {not_there, not_there, not_there, not_there};
  }
  const std::vector<double> means = means_of_pairs(differences);
  const double half_alpha = 0.5 * (1.0 - confidence);
  Tail tail = differences.size() <= most_exact ? exact_tail(differences.size(), half_alpha)
                                               : normal_tail(differences.size(), half_alpha);
  // Of no mean beyond the ends, R takes the first and the last mean too.
  if (tail.beyond == 0) tail = {1, std::pow(0.5, static_cast<double>(differences.size()))};
  return {median_of_sorted(means), means[tail.beyond - 1], means[means.size() - tail.beyond],
          1.0 - 2.0 * tail.probability};
}

}  // namespace mien::pipeline
