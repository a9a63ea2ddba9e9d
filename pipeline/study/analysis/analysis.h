#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/base/statistics/partition.h"
#include "pipeline/base/statistics/ward.h"
#include "pipeline/manifest/ratings/answers/study_answers.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/quantification.h"

namespace mien::pipeline {

struct AnalysisOptions {
  Thresholds thresholds;
  Deviation deviation = Deviation::population;
  std::optional<int> clusters = 4;  ///< number of clusters; empty: suggested_clusters
  std::vector<std::string>
      names;  ///< cluster names in dendrogram order; empty: assigned automatically
};

/// A cluster of scales with similar impressions: a primary parameter.
struct ScaleCluster {
  std::string name;
  std::string japanese;             ///< may be empty
  std::vector<int> members;         ///< rows of A, nearest to the centroid first
  std::vector<double> to_centroid;  ///< Euclidean distance of each member's row from `mean`
  Eigen::RowVectorXd mean;  ///< centroid: mean of the members' rows; a row of the matrix of primary
                            ///< parameters × examples
};

/// The analysis of answers: from the impression matrix to the primary parameters (adjective paper,
/// sections 3.1 to 3.3 and 3.5).
struct Analysis {
  Impressions impressions;            ///< the impression matrix A: scales with answers × examples
  std::vector<Quantity> quantities;   ///< one per row of A
  std::vector<Agreement> agreements;  ///< one per row of A
  std::vector<int> clustered;  ///< rows of A that were clustered: the leaves of the dendrogram
  bool none_retained = false;  ///< the thresholds exclude every scale, so all are clustered
  std::optional<Thresholds> suggested;  ///< looser thresholds, if no scale is retained
  Linkage linkage;
  Partition partition;         ///< clusters of the leaves
  int suggested_clusters = 1;  ///< number of clusters at the largest gap between merge heights
  std::vector<ScaleCluster> clusters;  ///< in dendrogram order
  std::vector<StudyWarning> warnings;  ///< about the answers, then about the analysis
};

/// Analyses answers. Without given names, each cluster is named after the group of the scales file
/// with the highest Jaccard index or, if no remaining group shares a scale with it, by its number:
/// "cluster-2". A group names at most one cluster; the pairs of cluster and group with the highest
/// index are matched first.
///
/// Throws Error for an example without ratings on some scale, for names whose number differs from
/// that of the clusters, and for a name that is empty, repeated or the id of a scale.
Analysis analyse(const StudyAnswers& answers, const ScaleSet& scales,
                 const std::vector<RatedExample>& examples, const AnalysisOptions& options);

/// Names the clusters of an analysis as analyse() does. Throws Error.
void name_clusters(Analysis& analysis, const ScaleSet& scales,
                   const std::vector<std::string>& given);

/// The high ends of the `words` most central scales of a cluster, as suggestions for its name:
/// "fast, quick".
std::string central_words(const Analysis& analysis, const ScaleCluster& cluster,
                          const ScaleSet& scales, int words = 3);

}  // namespace mien::pipeline
