#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/analysis/analysis.h"

namespace mien::pipeline {

/// Agreement between an analysis of the adjective pairs and the clusters published in the adjective
/// paper.
struct PublishedComparison {
  std::string table;         ///< "Table 2" or "Table 3"
  int retained_in_both = 0;  ///< number of adjective pairs
  int retained_only_here = 0;
  int retained_only_published = 0;
  double retention_agreement = 0.0;  ///< share of the rated pairs that both retain or both exclude
  double rand = 0.0;  ///< Rand index of the clusters of the adjective pairs retained in both
  double adjusted_rand = 0.0;
};

/// Compares an analysis with Tables 2 and 3. Empty unless every scale with answers is an adjective
/// pair of the paper. If the thresholds exclude all scales, all of them count as retained here,
/// since all are clustered.
std::vector<PublishedComparison> compare_with_published(const Analysis& analysis);

/// A row for each table.
WrittenTable published_table(const std::vector<PublishedComparison>& comparisons, bool simulated);

}  // namespace mien::pipeline
