#include "pipeline/base/statistics/ward.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace mien::pipeline {

namespace {

/// The clusters there are at one moment. A cluster lives in the slot of its lowest vector, so that
/// slots in ascending order are clusters in the order in which ties are decided.
class Clusters {
 public:
  explicit Clusters(const Eigen::MatrixXd& rows) : squared_(rows.rows(), rows.rows()) {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      slots_.push_back({static_cast<int>(i), {static_cast<int>(i)}});
      alive_.push_back(static_cast<int>(i));
      for (Eigen::Index k = 0; k <= i; ++k)
        squared_(i, k) = squared_(k, i) = (rows.row(i) - rows.row(k)).squaredNorm();
    }
  }

  /// Merges the nearest two into cluster `number`.
  Merge merge_nearest(int number) {
    int low = alive_[0];
    int high = alive_[1];
    for (auto i = alive_.begin(); i != alive_.end(); ++i) {
      for (auto k = std::next(i); k != alive_.end(); ++k) {
        // Sums in another order must not decide a tie.
        if (squared_(*k, *i) >= squared_(high, low) * (1.0 - 1e-12)) continue;
        low = *i;
        high = *k;
      }
    }
    return merge(low, high, number);
  }

 private:
  struct Cluster {
    int number;
    std::vector<int> members;
  };

  Cluster& slot(int i) { return slots_[static_cast<size_t>(i)]; }

  Merge merge(int low, int high, int number) {
    const double squared = squared_(high, low);
    update_distances(low, high);
    Cluster& kept = slot(low);
    Cluster& gone = slot(high);
    Merge merge{kept.number, gone.number, {}, 0.5 * squared, std::sqrt(squared)};
    std::merge(kept.members.begin(), kept.members.end(), gone.members.begin(), gone.members.end(),
               std::back_inserter(merge.members));
    kept = {number, merge.members};
    alive_.erase(std::lower_bound(alive_.begin(), alive_.end(), high));
    return merge;
  }

  void update_distances(int low, int high) {
    const double between = squared_(high, low);
    const auto n_low = static_cast<double>(slot(low).members.size());
    const auto n_high = static_cast<double>(slot(high).members.size());
    for (const int k : alive_) {
      if (k == low || k == high) continue;
      const auto n = static_cast<double>(slot(k).members.size());
      const double squared =
          ((n + n_low) * squared_(k, low) + (n + n_high) * squared_(k, high) - n * between) /
          (n + n_low + n_high);
      squared_(k, low) = squared_(low, k) = std::max(squared, 0.0);
    }
  }

  Eigen::MatrixXd squared_;  ///< 2ΔE of merging the clusters in two slots
  std::vector<Cluster> slots_;
  std::vector<int> alive_;  ///< slots in use, ascending
};

void append_leaves(const Linkage& linkage, int cluster, std::vector<int>& order) {
  if (cluster < linkage.leaves) {
    order.push_back(cluster);
    return;
  }
  const Merge& merge = linkage.merges[static_cast<size_t>(cluster - linkage.leaves)];
  append_leaves(linkage, merge.first, order);
  append_leaves(linkage, merge.second, order);
}

}  // namespace

Linkage ward(const Eigen::MatrixXd& rows) {
  assert(rows.allFinite());
  Linkage linkage;
  linkage.leaves = static_cast<int>(rows.rows());
  Clusters clusters(rows);
  for (int step = 0; step + 1 < linkage.leaves; ++step)
    linkage.merges.push_back(clusters.merge_nearest(linkage.leaves + step));
  return linkage;
}

std::vector<int> leaf_order(const Linkage& linkage) {
  std::vector<int> order;
  if (linkage.leaves > 0) append_leaves(linkage, 2 * linkage.leaves - 2, order);
  return order;
}

}  // namespace mien::pipeline
