#include "pipeline/base/statistics/wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

}  // namespace

Wilcoxon wilcoxon(const std::vector<double>& differences, WilcoxonMode mode, WilcoxonZeros zeros) {
  Wilcoxon result;
  result.pairs = static_cast<int>(differences.size());
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

}  // namespace mien::pipeline
