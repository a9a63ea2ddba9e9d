#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// One step of a hierarchical clustering. Clusters are numbered: 0 … n − 1 are the single vectors,
/// and n + k is the result of step k.
struct Merge {
  int first = 0;   ///< of the two clusters, the one that contains the vector of lowest index
  int second = 0;  ///< the other cluster
  std::vector<int> members;  ///< indices of the new cluster's vectors, ascending
  double increase = 0.0;     ///< ΔE, the increase of the sum of squared distances to the means
  double height = 0.0;       ///< √(2ΔE), as in SciPy's "ward" and R's "ward.D2"
};

/// A complete hierarchical clustering: n − 1 merges of n vectors with non-decreasing ΔE.
struct Linkage {
  int leaves = 0;
  std::vector<Merge> merges;
};

/// Ward's clustering (1963) of the rows of a matrix: each step merges the two clusters whose union
/// increases E = Σ‖a − mean of its cluster‖² least. Distances are updated by the recurrence of
/// Lance and Williams (1967) on squared Euclidean distances. Of equally near pairs (to one part in
/// 10¹²) the one with the lowest vector indices is merged first. The values must be finite. O(n³)
/// time with a small constant, O(n²) memory: 500 × 500 takes well below a second.
Linkage ward(const Eigen::MatrixXd& rows);

/// Order of the vectors along the dendrogram without crossing branches; in each merge `first`
/// precedes `second`.
std::vector<int> leaf_order(const Linkage& linkage);

}  // namespace mien::pipeline
