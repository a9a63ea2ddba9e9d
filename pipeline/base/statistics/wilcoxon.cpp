#include "pipeline/base/statistics/wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <boost/math/distributions/normal.hpp>

namespace mien::pipeline {

namespace {

/// A difference and twice its rank among the absolute differences, which is whole for ties too.
struct Ranked {
  double difference;
  int doubled_rank;
};

std::vector<Ranked> ranked(std::vector<double> differences) {
  std::ranges::sort(differences, {}, [](double d) { return std::abs(d); });
  std::vector<Ranked> result;
  for (std::size_t first = 0; first < differences.size();) {
    std::size_t end = first;
    while (end < differences.size() && std::abs(differences[end]) == std::abs(differences[first]))
      ++end;
    // Ranks first + 1 … end have the mean (first + 1 + end)/2.
    for (std::size_t i = first; i < end; ++i)
      result.push_back({differences[i], static_cast<int>(first + 1 + end)});
    first = end;
  }
  return result;
}

/// Ranked differences that share their size with another.
int tied_in(const std::vector<Ranked>& ranks) {
  int tied = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const bool before = i > 0 && ranks[i - 1].doubled_rank == ranks[i].doubled_rank;
    const bool after = i + 1 < ranks.size() && ranks[i + 1].doubled_rank == ranks[i].doubled_rank;
    tied += before || after ? 1 : 0;
  }
  return tied;
}

/// P(W+ ≤ w) and P(W+ ≥ w) when each rank has either sign with probability ½.
double two_sided(const std::vector<Ranked>& ranks, int doubled_w) {
  std::vector<double> probability = {1.0};
  for (const Ranked& r : ranks) {
    const auto shift = static_cast<std::size_t>(r.doubled_rank);
    std::vector<double> next(probability.size() + shift, 0.0);
    for (std::size_t w = 0; w < probability.size(); ++w) {
      next[w] += 0.5 * probability[w];
      next[w + shift] += 0.5 * probability[w];
    }
    probability = std::move(next);
  }
  double at_most = 0.0;
  double at_least = 0.0;
  for (std::size_t w = 0; w < probability.size(); ++w) {
    if (static_cast<int>(w) <= doubled_w) at_most += probability[w];
    if (static_cast<int>(w) >= doubled_w) at_least += probability[w];
  }
  return std::min(1.0, 2.0 * std::min(at_most, at_least));
}

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

/// Number of Walsh averages beyond each end of the interval, and the probability of either tail.
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

Wilcoxon wilcoxon(const std::vector<double>& differences, WilcoxonMode mode, WilcoxonZeros zeros) {
  Wilcoxon result;
  result.pairs = static_cast<int>(differences.size());
  if (differences.empty())
    result.p = result.rank_biserial = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> considered = differences;
  if (zeros == WilcoxonZeros::wilcox) std::erase(considered, 0.0);
  std::vector<Ranked> ranks = ranked(considered);
  double squares_of_zeros = 0.0;
  int doubled_zeros = 0;
  for (const Ranked& r : ranks) {
    if (r.difference != 0.0) break;  // they come first
    squares_of_zeros += 0.25 * r.doubled_rank * r.doubled_rank;
    doubled_zeros += r.doubled_rank;
  }
  std::erase_if(ranks, [](const Ranked& r) { return r.difference == 0.0; });
  result.used = static_cast<int>(ranks.size());
  result.zeros = result.pairs - result.used;
  result.tied = tied_in(ranks);
  if (ranks.empty()) return result;

  int doubled_plus = 0;
  int doubled_all = 0;
  double squares = 0.0;
  for (const Ranked& r : ranks) {
    if (r.difference > 0.0) doubled_plus += r.doubled_rank;
    doubled_all += r.doubled_rank;
    squares += 0.25 * r.doubled_rank * r.doubled_rank;
  }
  result.w_plus = 0.5 * doubled_plus;
  result.w_minus = 0.5 * (doubled_all - doubled_plus);
  result.rank_biserial = (result.w_plus - result.w_minus) / (result.w_plus + result.w_minus);
  const bool split = zeros == WilcoxonZeros::zsplit;
  if (split) {
    result.w_plus += 0.25 * doubled_zeros;
    result.w_minus += 0.25 * doubled_zeros;
  }
  if (mode == WilcoxonMode::exact) {
    result.p = two_sided(ranks, doubled_plus);
    return result;
  }
  if (split) squares += squares_of_zeros;
  const double departure = 0.5 * (result.w_plus - result.w_minus);
  const double correction =
      mode == WilcoxonMode::corrected && departure != 0.0 ? std::copysign(0.5, departure) : 0.0;
  result.z = (departure - correction) / std::sqrt(0.25 * squares);
  result.p = 2.0 * cdf(boost::math::normal(), -std::abs(result.z));
  return result;
}

HodgesLehmann hodges_lehmann(const std::vector<double>& differences, double confidence) {
  if (differences.empty()) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown, unknown};
  }
  const std::vector<double> means = means_of_pairs(differences);
  const double half_alpha = 0.5 * (1.0 - confidence);
  Tail tail = differences.size() <= most_exact ? exact_tail(differences.size(), half_alpha)
                                               : normal_tail(differences.size(), half_alpha);
  // If no mean is beyond the ends, the first and the last are used, as in R.
  if (tail.beyond == 0) tail = {1, std::pow(0.5, static_cast<double>(differences.size()))};
  return {median_of_sorted(means), means[tail.beyond - 1], means[means.size() - tail.beyond],
          1.0 - 2.0 * tail.probability};
}

}  // namespace mien::pipeline
