#include "pipeline/base/statistics/partition.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace mien::pipeline {

namespace {

double pairs_of(double n) { return 0.5 * n * (n - 1.0); }

/// Numbers of pairs of items in one group in a, in b, in both, and of all pairs.
struct PairCounts {
  double in_a = 0.0;
  double in_b = 0.0;
  double in_both = 0.0;
  double all = 0.0;
};

PairCounts count_pairs(const Partition& a, const Partition& b) {
  assert(a.group.size() == b.group.size());
  std::map<int, int> rows;
  std::map<int, int> columns;
  std::map<std::pair<int, int>, int> cells;
  for (size_t i = 0; i < a.group.size(); ++i) {
    ++rows[a.group[i]];
    ++columns[b.group[i]];
    ++cells[{a.group[i], b.group[i]}];
  }
  PairCounts counts;
  for (const auto& [group, n] : rows) counts.in_a += pairs_of(n);
  for (const auto& [group, n] : columns) counts.in_b += pairs_of(n);
  for (const auto& [groups, n] : cells) counts.in_both += pairs_of(n);
  counts.all = pairs_of(static_cast<double>(a.group.size()));
  return counts;
}

}  // namespace

Partition cut(const Linkage& linkage, int clusters) {
  assert(clusters >= 1 && clusters <= std::max(linkage.leaves, 1));
  const auto n = static_cast<size_t>(linkage.leaves);
  std::vector<int> lowest(n);  // lowest vector of the cluster that each is in
  for (size_t i = 0; i < n; ++i) lowest[i] = static_cast<int>(i);
  for (int step = 0; step < linkage.leaves - clusters; ++step) {
    const std::vector<int>& members = linkage.merges[static_cast<size_t>(step)].members;
    for (const int member : members) lowest[static_cast<size_t>(member)] = members.front();
  }
  Partition partition;
  partition.group.resize(n);
  std::map<int, int> numbers;
  for (const int leaf : leaf_order(linkage)) {
    const auto [number, added] =
        numbers.emplace(lowest[static_cast<size_t>(leaf)], partition.groups);
    if (added) ++partition.groups;
    partition.group[static_cast<size_t>(leaf)] = number->second;
  }
  return partition;
}

int clusters_by_largest_gap(const Linkage& linkage) {
  if (linkage.leaves < 3) return linkage.leaves;
  int best = 2;
  double widest = -1.0;
  for (int clusters = 2; clusters < linkage.leaves; ++clusters) {
    const auto next_merge = static_cast<size_t>(linkage.leaves - clusters);
    const double gap = linkage.merges[next_merge].height - linkage.merges[next_merge - 1].height;
    if (gap > widest * (1.0 + 1e-12)) {
      widest = gap;
      best = clusters;
    }
  }
  return best;
}

double cut_height(const Linkage& linkage, int clusters) {
  const int kept = linkage.leaves - clusters;
  const auto height = [&](int step) { return linkage.merges[static_cast<size_t>(step)].height; };
  if (linkage.merges.empty()) return 0.0;
  const double below = kept == 0 ? 0.0 : height(kept - 1);
  const double above =
      clusters <= 1 ? 1.1 * height(linkage.leaves - 2) : height(linkage.leaves - clusters);
  return 0.5 * (below + above);
}

double rand_index(const Partition& a, const Partition& b) {
  const PairCounts c = count_pairs(a, b);
  return c.all == 0.0 ? 1.0 : 1.0 - (c.in_a + c.in_b - 2.0 * c.in_both) / c.all;
}

double adjusted_rand_index(const Partition& a, const Partition& b) {
  const PairCounts c = count_pairs(a, b);
  if (c.all == 0.0) return 1.0;
  const double by_chance = c.in_a * c.in_b / c.all;
  const double most = 0.5 * (c.in_a + c.in_b);
  return most == by_chance ? 1.0 : (c.in_both - by_chance) / (most - by_chance);
}

}  // namespace mien::pipeline
