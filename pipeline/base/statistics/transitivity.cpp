#include "pipeline/base/statistics/transitivity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

namespace mien::pipeline {

namespace {

/// Number of wins of each stimulus (row) over each other (column); ties count half if
/// `ties_share` is ½.
Eigen::MatrixXd wins_of(const std::vector<PairCount>& counts, std::size_t stimuli,
                        double ties_share) {
  const auto n = static_cast<Eigen::Index>(stimuli);
  Eigen::MatrixXd wins = Eigen::MatrixXd::Zero(n, n);
  for (const PairCount& count : counts) {
    const auto first = static_cast<Eigen::Index>(count.first);
    const auto second = static_cast<Eigen::Index>(count.second);
    wins(first, second) += count.first_wins + ties_share * count.ties;
    wins(second, first) += count.second_wins + ties_share * count.ties;
  }
  return wins;
}

/// Proportion of choices of a over b; NaN if they were not compared.
double share_of(const Eigen::MatrixXd& wins, Eigen::Index a, Eigen::Index b) {
  return wins(a, b) / (wins(a, b) + wins(b, a));
}

/// Number of forms of transitivity (0 … 3) that the triad violates in its best order.
int violated_forms(const Eigen::MatrixXd& wins, std::array<Eigen::Index, 3> triad) {
  int fewest = 3;
  do {
    const double ab = share_of(wins, triad[0], triad[1]);
    const double bc = share_of(wins, triad[1], triad[2]);
    if (ab < 0.5 || bc < 0.5) continue;
    const double ac = share_of(wins, triad[0], triad[2]);
    const int violated =
        (ac < 0.5 ? 1 : 0) + (ac < std::min(ab, bc) ? 1 : 0) + (ac < std::max(ab, bc) ? 1 : 0);
    fewest = std::min(fewest, violated);
  } while (std::ranges::next_permutation(triad).found);
  return fewest;
}

}  // namespace

std::optional<CircularTriads> circular_triads(const std::vector<PairCount>& counts,
                                              std::size_t stimuli) {
  if (stimuli < 3) return std::nullopt;
  const Eigen::MatrixXd wins = wins_of(counts, stimuli, 0.0);
  const auto n = static_cast<Eigen::Index>(stimuli);
  double squares = 0.0;  // of the numbers of stimuli over which each is preferred
  for (Eigen::Index i = 0; i < n; ++i) {
    double preferred = 0.0;
    for (Eigen::Index k = 0; k < n; ++k) {
      if (i == k) continue;
      if (wins(i, k) == wins(k, i)) return std::nullopt;
      preferred += wins(i, k) > wins(k, i) ? 1.0 : 0.0;
    }
    squares += preferred * preferred;
  }
  const auto size = static_cast<double>(n);
  CircularTriads result;
  result.circular = static_cast<int>(
      std::lround(size * (size - 1.0) * (2.0 * size - 1.0) / 12.0 - 0.5 * squares));
  const double at_most = n % 2 == 1 ? size * size * size - size : size * size * size - 4.0 * size;
  result.most = static_cast<int>(std::lround(at_most / 24.0));
  result.by_chance = size * (size - 1.0) * (size - 2.0) / 24.0;
  result.zeta = 1.0 - static_cast<double>(result.circular) / result.most;
  return result;
}

TransitivityViolations transitivity_violations(const std::vector<PairCount>& counts,
                                               std::size_t stimuli) {
  const Eigen::MatrixXd wins = wins_of(counts, stimuli, 0.5);
  const auto n = static_cast<Eigen::Index>(stimuli);
  const auto is_compared = [&](Eigen::Index i, Eigen::Index k) {
    return wins(i, k) + wins(k, i) > 0.0;
  };
  TransitivityViolations result;
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = a + 1; b < n; ++b) {
      for (Eigen::Index c = b + 1; c < n; ++c) {
        if (!is_compared(a, b) || !is_compared(b, c) || !is_compared(a, c)) continue;
        const int violated = violated_forms(wins, {a, b, c});
        ++result.triads;
        result.strong += violated >= 1 ? 1 : 0;
        result.moderate += violated >= 2 ? 1 : 0;
        result.weak += violated >= 3 ? 1 : 0;
      }
    }
  }
  return result;
}

}  // namespace mien::pipeline
