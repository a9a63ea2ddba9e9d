#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/scales/feature_parameters.h"
#include "pipeline/study/analysis/dendrogram.h"

namespace mien::pipeline {

/// Clusters of motion features that vary together over the examples, computed by the same method as
/// clusters of adjective pairs.
struct FeatureClusters {
  std::vector<std::string> features;  ///< ids of the features that every example has
  Eigen::MatrixXd scaled;             ///< features × examples: 0 … 1, or z-scores
  Linkage linkage;
  Partition partition;
  std::vector<std::string> names;  ///< cluster names: those of the most similar published groups
  int suggested_clusters = 1;      ///< number of clusters at the largest gap between merge heights
  double rand = 0.0;               ///< Rand index against the published groups
  double adjusted_rand = 0.0;
};

/// Clusters the features, scaled over the examples, by Ward's method and cuts the tree into
/// `clusters`. Each published group names at most one cluster, the pairs with the highest Jaccard
/// index first; the remaining clusters are named like "cluster-2". Throws Error for more clusters
/// than features.
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
