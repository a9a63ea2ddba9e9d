#include "pipeline/study/analysis/feature_clusters.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {
namespace {

/// Features that move together within their published group, and not across groups.
FeatureParameters published_groups() {
  FeatureParameters parameters;
  parameters.table.names = feature_parameter_names();
  const auto rows = static_cast<Eigen::Index>(parameters.table.names.size());
  parameters.table.values.resize(rows, 4);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const int index =
        motion::find_motion_feature(parameters.table.names[static_cast<std::size_t>(r)]);
    const int group =
        index < 0
            ? 0
            : static_cast<int>(motion::motion_features()[static_cast<std::size_t>(index)].group);
    for (Eigen::Index i = 0; i < 4; ++i) {
      parameters.table.values(r, i) = (i == group ? 1.0 : 0.0) + 0.001 * static_cast<double>(r);
    }
  }
  return parameters;
}

TEST(FeatureClusters, FindGroupsThatAreThereAndNameThem) {
  const FeatureClusters clusters = cluster_features(published_groups(), 4);
  EXPECT_EQ(clusters.features.size(), 51u);
  EXPECT_DOUBLE_EQ(clusters.rand, 1.0);
  EXPECT_DOUBLE_EQ(clusters.adjusted_rand, 1.0);
  const CsvTable table = parse_csv(feature_clusters_table(clusters).csv, "c.csv");
  ASSERT_EQ(table.rows.size(), 51u);
  for (const auto& row : table.rows) EXPECT_EQ(row[1].text, row[3].text) << row[2].text;
}

TEST(FeatureClusters, BeyondThePublishedGroupsAreNumbered) {
  const FeatureClusters clusters = cluster_features(published_groups(), 5);
  int numbered = 0;
  for (const std::string& name : clusters.names) numbered += name.starts_with("cluster-") ? 1 : 0;
  EXPECT_EQ(numbered, 1);
  EXPECT_LT(clusters.adjusted_rand, 1.0);
}

TEST(FeatureClusters, MayBeOfZScores) {
  const FeatureClusters clusters =
      cluster_features(published_groups(), 4, motion::FeatureScaling::z_score);
  EXPECT_DOUBLE_EQ(clusters.rand, 1.0);
  for (Eigen::Index r = 0; r < clusters.scaled.rows(); ++r) {
    const auto row = clusters.scaled.row(r);
    EXPECT_NEAR(row.mean(), 0.0, 1e-12);
    EXPECT_NEAR(row.squaredNorm() / static_cast<double>(row.size()), 1.0, 1e-12);
  }
}

TEST(FeatureClusters, CannotBeMoreThanFeatures) {
  EXPECT_THROW(cluster_features(published_groups(), 52), Error);
}

TEST(FeatureClusters, TellEveryMerge) {
  const CsvTable table =
      parse_csv(feature_linkage_table(cluster_features(published_groups(), 4)).csv, "l.csv");
  ASSERT_EQ(table.rows.size(), 50u);
  EXPECT_EQ(table.rows.back()[3].text, "51");
}

}  // namespace
}  // namespace mien::pipeline
