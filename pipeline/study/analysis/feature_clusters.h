#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/manifest/ratings/scales/feature_parameters.h"
#include "pipeline/study/analysis/dendrogram.h"

namespace mien::pipeline {

/// Motion features that the examples have alike, found by the code that clusters adjective pairs.
struct FeatureClusters {
  std::vector<std::string> features;  ///< ids: those that every example has
  Eigen::MatrixXd scaled;             ///< features × examples: 0 … 1, or z scores
  Linkage linkage;
  Partition partition;
  std::vector<std::string> names;  ///< of the clusters: the published group each is likest
  int suggested_clusters = 1;      ///< by the largest gap
  double rand = 0.0;               ///< against the published groups
  double adjusted_rand = 0.0;
};

/// Ward's clustering of the features as scaled over the examples, cut into `clusters`. Each
/// published group names at most one cluster, the likest pair first (Jaccard); others are
/// "cluster-2". Throws Error for more clusters than features.
FeatureClusters cluster_features(const FeatureParameters& parameters, int clusters,
                                 motion::FeatureScaling scaling = motion::FeatureScaling::min_max);

/// The tree with its cut.
Dendrogram dendrogram_of(const FeatureClusters& clusters);

/// A row a merge: step, first, second (a feature, or "#3" for what step 3 made), size, delta_e,
/// height.
std::string feature_linkage_csv(const FeatureClusters& clusters);

/// A row a feature: cluster (1 …, along the dendrogram), name, feature, published_group.
std::string feature_clusters_csv(const FeatureClusters& clusters);

/// A row a feature and example: feature, example, scaled (0 … 1 over the examples, or z scores).
std::string scaled_features_csv(const FeatureClusters& clusters,
                                const std::vector<std::string>& examples);

}  // namespace mien::pipeline
