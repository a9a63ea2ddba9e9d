#pragma once

#include <vector>

#include "pipeline/base/statistics/ward.h"

namespace mien::pipeline {

/// A partition of items into groups: the group of each item, numbered from 0 without gaps.
struct Partition {
  std::vector<int> group;
  int groups = 0;
};

/// Cuts the dendrogram into `clusters` groups (1 … leaves), numbered along it (leaf_order).
Partition cut(const Linkage& linkage, int clusters);

/// Number of clusters, 2 … leaves − 1, at the widest gap between successive heights; of equal gaps
/// the one with fewer clusters. Below three leaves, the number of leaves.
int clusters_by_largest_gap(const Linkage& linkage);

/// Height at which to draw the cut into `clusters`: midway between the highest merge that it keeps
/// (0 if it keeps none) and the lowest that it undoes (1.1 times the highest if it undoes none). 0
/// for fewer than two leaves.
double cut_height(const Linkage& linkage, int clusters);

/// Rand index (1971): proportion of pairs of items that two partitions of the same items both put
/// into one group or both separate. 1 for fewer than two items.
double rand_index(const Partition& a, const Partition& b);

/// Rand index corrected for chance (Hubert and Arabie 1985): 1 for equal partitions, 0 on average
/// for unrelated ones. 1 if both consist of one group, or if in both every group is a single item.
double adjusted_rand_index(const Partition& a, const Partition& b);

}  // namespace mien::pipeline
