#pragma once

#include <vector>

#include "pipeline/base/statistics/ward.h"

namespace mien::pipeline {

/// Things told apart into groups: the group of each, numbered from 0 without gaps.
struct Partition {
  std::vector<int> group;
  int groups = 0;
};

/// Undoes the last merges until `clusters` are left (1 … leaves). Groups are numbered along the
/// dendrogram (leaf_order).
Partition cut(const Linkage& linkage, int clusters);

/// How many clusters the widest gap between two successive heights suggests, from 2 to leaves − 1;
/// of equal gaps the one with fewer clusters. Everything in one (or as many as there are leaves)
/// below three leaves.
int clusters_by_largest_gap(const Linkage& linkage);

/// Height at which to draw the cut into `clusters`: midway between the merges that it undoes and
/// those that it keeps.
double cut_height(const Linkage& linkage, int clusters);

/// Share of the pairs of things on which two partitions agree that they are in one group, or not
/// (Rand 1971). Both must be about the same things. 1 for fewer than two.
double rand_index(const Partition& a, const Partition& b);

/// The same, corrected for chance (Hubert and Arabie 1985): 1 for equal partitions, 0 on average
/// for unrelated ones. 1 when both put everything together, or everything apart.
double adjusted_rand_index(const Partition& a, const Partition& b);

}  // namespace mien::pipeline
