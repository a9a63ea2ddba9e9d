#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/scales/feature_parameters.h"
#include "pipeline/study/analysis/dendrogram.h"

namespace mien::pipeline {

/// Clusters of motion features that vary together over the examples, by the method for adjective
/// pairs.
struct FeatureClusters {
  std::vector<std::string> features;  ///< ids: those that every example has
  Eigen::MatrixXd scaled;             ///< features × examples: 0 … 1, or z scores
  Linkage linkage;
  Partition partition;
  std::vector<std::string> names;  ///< of the clusters, after the most similar published groups
  int suggested_clusters = 1;      ///< by the largest gap
  double rand = 0.0;               ///< against the published groups
  double adjusted_rand = 0.0;
};

/// Ward's clustering of the features as scaled over the examples, cut into `clusters`. Each
/// published group names at most one cluster, the most similar pair first (Jaccard); others are
/// "cluster-2". Throws Error for more clusters than features.
FeatureClusters cluster_features(const FeatureParameters& parameters, int clusters,
                                 motion::FeatureScaling scaling = motion::FeatureScaling::min_max);

/// The dendrogram of features, with the cut into clusters.
Dendrogram dendrogram_of(const FeatureClusters& clusters);

/// A row for each merge.
WrittenTable feature_linkage_table(const FeatureClusters& clusters);

/// A row for each feature.
WrittenTable feature_clusters_table(const FeatureClusters& clusters);

/// A row for each feature and example.
WrittenTable scaled_features_table(const FeatureClusters& clusters,
                                   const std::vector<std::string>& examples);

}  // namespace mien::pipeline
