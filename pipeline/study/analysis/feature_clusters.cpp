#include "pipeline/study/analysis/feature_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "motion/error.h"

namespace mien::pipeline {

namespace {

const motion::MotionFeature& feature_of(const std::string& id) {
  return motion::motion_features()[static_cast<std::size_t>(motion::find_motion_feature(id))];
}

Partition published_partition(const std::vector<std::string>& features) {
  Partition partition;
  partition.groups = motion::feature_group_count;
  for (const std::string& id : features)
    partition.group.push_back(static_cast<int>(feature_of(id).group));
  return partition;
}

/// Jaccard index of a cluster and a published group.
double jaccard_index(const Partition& found, int cluster, const Partition& published, int group) {
  int both = 0;
  int either = 0;
  for (std::size_t i = 0; i < found.group.size(); ++i) {
    const bool here = found.group[i] == cluster;
    const bool there = published.group[i] == group;
    both += here && there ? 1 : 0;
    either += here || there ? 1 : 0;
  }
  return either > 0 ? static_cast<double>(both) / either : 0.0;
}

std::vector<std::string> names_of(const Partition& found, const Partition& published) {
  std::vector<std::string> names(static_cast<std::size_t>(found.groups));
  std::set<int> taken;
  while (static_cast<int>(taken.size()) < std::min(found.groups, published.groups)) {
    double best = 0.0;
    int cluster = -1;
    int group = -1;
    for (int c = 0; c < found.groups; ++c) {
      for (int g = 0; g < published.groups; ++g) {
        if (!names[static_cast<std::size_t>(c)].empty() || taken.contains(g)) continue;
        const double alike = jaccard_index(found, c, published, g);
        if (alike <= best) continue;
        best = alike;
        cluster = c;
        group = g;
      }
    }
    if (cluster < 0) break;
    taken.insert(group);
    names[static_cast<std::size_t>(cluster)] =
        motion::id_of(static_cast<motion::FeatureGroup>(group));
  }
  for (std::size_t c = 0; c < names.size(); ++c)
    if (names[c].empty()) names[c] = fmt::format("cluster-{}", c + 1);
  return names;
}

std::string node_name(const FeatureClusters& clusters, int node) {
  if (node < clusters.linkage.leaves) return clusters.features[static_cast<std::size_t>(node)];
  return fmt::format("#{}", node - clusters.linkage.leaves + 1);
}

struct FeatureMerge {
  const FeatureClusters& all;
  std::size_t step;  ///< from 0

  const Merge& of() const { return all.linkage.merges[step]; }
};

struct ClusteredFeature {
  const FeatureClusters& all;
  int leaf;

  const std::string& id() const { return all.features[static_cast<std::size_t>(leaf)]; }
  int cluster() const { return all.partition.group[static_cast<std::size_t>(leaf)]; }
};

struct ScaledFeature {
  std::string feature;
  std::string example;
  double scaled;
};

constexpr auto linkage_of_features = table_of<FeatureMerge>(
    "linkage.csv", "merge of two clusters",
    {{"step", "", "number of the merge, from 1", [](auto& r) { return r.step + 1; }},
     {"first", "", "a feature, or a cluster: #3 is that made in step 3",
      [](auto& r) { return node_name(r.all, r.of().first); }},
     {"second", "", "the feature or cluster merged with it",
      [](auto& r) { return node_name(r.all, r.of().second); }},
     {"size", "", "number of features in the new cluster",
      [](auto& r) { return r.of().members.size(); }},
     {"delta_e", "", "ΔE: growth of the error sum of squares (Ward)",
      [](auto& r) { return shortest_measured(r.of().increase); }},
     {"height", "", "√(2ΔE): height in the dendrogram",
      [](auto& r) { return shortest_measured(r.of().height); }}});

constexpr auto clusters_of_features = table_of<ClusteredFeature>(
    "clusters.csv", "feature",
    {{"cluster", "", "its cluster, from 1 along the dendrogram",
      [](auto& r) { return r.cluster() + 1; }},
     {"name", "", "name of the cluster",
      [](auto& r) { return r.all.names[static_cast<std::size_t>(r.cluster())]; }},
     {"feature", "", "id of the motion feature", [](auto& r) { return r.id(); }},
     {"published_group", "", "its group in the adjective paper",
      [](auto& r) { return motion::id_of(feature_of(r.id()).group); }}});

constexpr auto scaled_columns = table_of<ScaledFeature>(
    "features.csv", "feature and example",
    {{"feature", "", "id of the motion feature", [](auto& r) { return r.feature; }},
     {"example", "", "example label", [](auto& r) { return r.example; }},
     {"scaled", "", "0–1 over the examples, or z scores", [](auto& r) { return r.scaled; }}});

/// Rows of min–max scaled values as z scores, which differ from them by origin and unit only.
Eigen::MatrixXd standardised(Eigen::MatrixXd rows) {
  rows.colwise() -= rows.rowwise().mean().eval();
  for (auto row : rows.rowwise()) {
    const double deviation = std::sqrt(row.squaredNorm() / static_cast<double>(row.size()));
    if (deviation > 0.0) row /= deviation;
  }
  return rows;
}

}  // namespace

FeatureClusters cluster_features(const FeatureParameters& parameters, int clusters,
                                 motion::FeatureScaling scaling) {
  FeatureClusters result;
  std::vector<int> rows;
  for (std::size_t r = 0; r < parameters.table.names.size(); ++r) {
    const std::string& name = parameters.table.names[r];
    if (motion::find_motion_feature(name) < 0) continue;  // a group
    result.features.push_back(name);
    rows.push_back(static_cast<int>(r));
  }
  if (clusters > static_cast<int>(rows.size()))
    throw Error(fmt::format("{} clusters of {} features", clusters, rows.size()),
                "ask for fewer clusters");
  result.scaled = parameters.table.values(rows, Eigen::all);
  if (scaling == motion::FeatureScaling::z_score) result.scaled = standardised(result.scaled);
  result.linkage = ward(result.scaled);
  result.partition = cut(result.linkage, clusters);
  result.suggested_clusters = clusters_by_largest_gap(result.linkage);
  const Partition published = published_partition(result.features);
  result.names = names_of(result.partition, published);
  result.rand = rand_index(result.partition, published);
  result.adjusted_rand = adjusted_rand_index(result.partition, published);
  return result;
}

Dendrogram dendrogram_of(const FeatureClusters& clusters) {
  Dendrogram dendrogram;
  dendrogram.title = "Clusters of motion features";
  dendrogram.subtitle = fmt::format("{} features scaled over {} examples; Ward's method",
                                    clusters.features.size(), clusters.scaled.cols());
  dendrogram.linkage = clusters.linkage;
  dendrogram.partition = clusters.partition;
  for (const std::string& id : clusters.features) dendrogram.leaves.push_back({id, ""});
  for (const std::string& name : clusters.names) dendrogram.clusters.push_back({name, ""});
  return dendrogram;
}

WrittenTable feature_linkage_table(const FeatureClusters& clusters) {
  std::vector<std::size_t> steps(clusters.linkage.merges.size());
  std::iota(steps.begin(), steps.end(), std::size_t{0});
  return linkage_of_features.of_parts(clusters, steps);
}

WrittenTable feature_clusters_table(const FeatureClusters& clusters) {
  return clusters_of_features.of_parts(clusters, leaf_order(clusters.linkage));
}

WrittenTable scaled_features_table(const FeatureClusters& clusters,
                                   const std::vector<std::string>& examples) {
  std::vector<ScaledFeature> rows;
  for (std::size_t r = 0; r < clusters.features.size(); ++r)
    for (std::size_t i = 0; i < examples.size(); ++i)
      rows.push_back({clusters.features[r], examples[i],
                      clusters.scaled(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(i))});
  return scaled_columns.of(rows);
}

}  // namespace mien::pipeline
