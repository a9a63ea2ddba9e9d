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
  std::optional<int> clusters = 4;  ///< empty: as the largest gap suggests
  std::vector<std::string> names;   ///< of the clusters along the dendrogram; may be empty
};

/// A cluster of scales that are used similarly: a primary parameter.
struct ScaleCluster {
  std::string name;
  std::string japanese;             ///< may be empty
  std::vector<int> members;         ///< rows of the impressions, nearest to the centroid first
  std::vector<double> to_centroid;  ///< distance of each member, in units of the impressions
  Eigen::RowVectorXd mean;          ///< of the members' rows: a row of A′
};

/// From answers to primary parameters: the adjective paper, sections 3.1 to 3.3 and 3.5.
struct Analysis {
  Impressions impressions;            ///< A, of every scale with answers
  std::vector<Quantity> quantities;   ///< one a row of A
  std::vector<Agreement> agreements;  ///< one a row of A
  std::vector<int> clustered;         ///< rows of A that the tree is of: its leaves
  bool none_retained =
      false;  ///< whether the thresholds exclude every scale; then all are clustered
  std::optional<Thresholds> suggested;  ///< when no scale is retained
  Linkage linkage;
  Partition partition;                 ///< of the leaves
  int suggested_clusters = 1;          ///< by the largest gap
  std::vector<ScaleCluster> clusters;  ///< along the dendrogram
  std::vector<StudyWarning> warnings;  ///< of the answers, then of the analysis
};

/// Analyses answers. Without given names a cluster gets the name of the most similar group of the
/// scales file (Jaccard; each group once, the most similar first), or "cluster-2" where there is
/// none.
///
/// Throws Error for an example without ratings on some scale, a number of names other than that of
/// clusters, and a name that is empty, repeated or that of a scale.
Analysis analyse(const StudyAnswers& answers, const ScaleSet& scales,
                 const std::vector<RatedExample>& examples, const AnalysisOptions& options);

/// Names the clusters of an analysis (analysis.h says how). Throws Error.
void name_clusters(Analysis& analysis, const ScaleSet& scales,
                   const std::vector<std::string>& given);

/// The high ends of a cluster's most central scales, as suggestions for its name: "fast, quick".
std::string central_words(const Analysis& analysis, const ScaleCluster& cluster,
                          const ScaleSet& scales, int words = 3);

}  // namespace mien::pipeline
