#include "pipeline/study/analysis/feature_clusters.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

const motion::MotionFeature& feature_of(const std::string& id) {
  return motion::motion_features()[static_cast<std::size_t>(motion::find_motion_feature(id))];
}

Partition published_partition(const std::vector<std::string>& features) {
  Partition partition;
  partition.groups = motion::feature_group_count;
  for (const std::string& id : features) {
    partition.group.push_back(static_cast<int>(feature_of(id).group));
  }
  return partition;
}

/// Members that a cluster and a published group have in common, as a share of both together.
double likeness(const Partition& found, int cluster, const Partition& published, int group) {
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
        const double alike = likeness(found, c, published, g);
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
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (names[c].empty()) names[c] = fmt::format("cluster-{}", c + 1);
  }
  return names;
}

std::string node_name(const FeatureClusters& clusters, int node) {
  if (node < clusters.linkage.leaves) return clusters.features[static_cast<std::size_t>(node)];
  return fmt::format("#{}", node - clusters.linkage.leaves + 1);
}

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
  if (clusters > static_cast<int>(rows.size())) {
    throw Error(fmt::format("{} clusters of {} features", clusters, rows.size()),
                "ask for fewer clusters");
  }
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

std::string feature_linkage_csv(const FeatureClusters& clusters) {
  CsvWriter csv({"step", "first", "second", "size", "delta_e", "height"});
  int step = 0;
  for (const Merge& merge : clusters.linkage.merges) {
    csv.row({std::to_string(++step), node_name(clusters, merge.first),
             node_name(clusters, merge.second), std::to_string(merge.members.size()),
             shortest_measured(merge.increase), shortest_measured(merge.height)});
  }
  return csv.text();
}

std::string feature_clusters_csv(const FeatureClusters& clusters) {
  CsvWriter csv({"cluster", "name", "feature", "published_group"});
  for (const int leaf : leaf_order(clusters.linkage)) {
    const std::string& id = clusters.features[static_cast<std::size_t>(leaf)];
    const int cluster = clusters.partition.group[static_cast<std::size_t>(leaf)];
    csv.row({std::to_string(cluster + 1), clusters.names[static_cast<std::size_t>(cluster)], id,
             std::string(motion::id_of(feature_of(id).group))});
  }
  return csv.text();
}

std::string scaled_features_csv(const FeatureClusters& clusters,
                                const std::vector<std::string>& examples) {
  CsvWriter csv({"feature", "example", "scaled"});
  for (std::size_t r = 0; r < clusters.features.size(); ++r) {
    for (std::size_t i = 0; i < examples.size(); ++i) {
      csv.row(
          {clusters.features[r], examples[i],
           shortest(clusters.scaled(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(i)))});
    }
  }
  return csv.text();
}

}  // namespace mien::pipeline
