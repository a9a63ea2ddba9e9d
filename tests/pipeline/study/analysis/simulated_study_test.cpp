#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/analysis/analysis.h"
#include "pipeline/study/analysis/published_clusters.h"

namespace mien::pipeline {
namespace {

Manifest simulated_study(const std::string& set, std::uint64_t seed) {
  Manifest manifest;
  manifest.examples.builtin = set;
  manifest.ratings.source = Ratings::Source::simulated;
  manifest.seed = seed;
  return manifest;
}

Analysis analysis_of(const Manifest& manifest) {
  const ScaleSet scales = builtin_scales();
  const std::vector<RatedExample> examples = rated_examples(manifest);
  const std::string csv = to_csv(simulated_answers(manifest));
  return analyse(study_answers(parse_csv(csv, "answers.csv"), scales, examples, {}), scales,
                 examples, {});
}

double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::ArrayXd x = a.array() - a.mean();
  const Eigen::ArrayXd y = b.array() - b.mean();
  return (x * y).sum() / std::sqrt((x * x).sum() * (y * y).sum());
}

TEST(SimulatedStudy, OfTwentySevenWalksFindsTheClustersOfTable3) {
  for (const std::uint64_t seed : {0, 1, 7, 42}) {
    const Analysis analysis = analysis_of(simulated_study("walks-27", seed));
    EXPECT_TRUE(analysis.impressions.simulated);
    const PublishedComparison table_3 = compare_with_published(analysis).at(1);
    ASSERT_EQ(table_3.table, "Table 3");
    EXPECT_GE(table_3.retained_in_both, 28) << seed;
    EXPECT_GE(table_3.retention_agreement, 38.0 / 41.0) << seed;
    EXPECT_GE(table_3.rand, 0.95) << seed;
    EXPECT_GE(table_3.adjusted_rand, 0.9) << seed;
    RecordProperty("adjusted_rand", std::to_string(table_3.adjusted_rand));
  }
}

TEST(SimulatedStudy, OfTwentySevenWalksNamesTheClustersAsThePaperDoes) {
  const Analysis analysis = analysis_of(simulated_study("walks-27", 0));
  std::vector<std::string> names;
  for (const ScaleCluster& cluster : analysis.clusters) names.push_back(cluster.name);
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"activeness", "clearness", "largeness", "quickness"}));
}

TEST(SimulatedStudy, PrimaryImpressionsRestOnDifferentThings) {
  const std::vector<StyledStimulus> walks = measured_profiles(motion::builtin_examples("walks-27"));
  Eigen::MatrixXd profiles(static_cast<Eigen::Index>(walks.size()), 4);
  for (size_t i = 0; i < walks.size(); ++i) {
    for (size_t a = 0; a < 4; ++a) {
      profiles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(a)) = walks[i].profile[a];
    }
  }
  for (Eigen::Index a = 0; a < 4; ++a) {
    EXPECT_GT(profiles.col(a).maxCoeff() - profiles.col(a).minCoeff(), 1.0);
    for (Eigen::Index b = 0; b < a; ++b) {
      EXPECT_LT(std::abs(correlation(profiles.col(a), profiles.col(b))), 0.9) << a << ' ' << b;
    }
  }
}

TEST(SimulatedStudy, TheTenWalksLookLikeTheirNames) {
  std::map<std::string, StyleProfile> seen;
  for (const StyledStimulus& walk : measured_profiles(motion::builtin_examples("walks-10"))) {
    seen[walk.name] = walk.profile;
  }
  EXPECT_GT(seen["brisk"][Quickness], seen["normal"][Quickness] + 0.2);
  EXPECT_LT(seen["slow"][Quickness], seen["normal"][Quickness] - 0.5);
  EXPECT_GT(seen["happy"][Activeness], seen["normal"][Activeness]);
  EXPECT_LT(seen["sad"][Activeness], seen["normal"][Activeness] - 0.5);
  EXPECT_GT(seen["proud"][Clearness], seen["normal"][Clearness]);
  EXPECT_LT(seen["afraid"][Clearness], -0.5);
  EXPECT_LT(seen["afraid"][Largeness], -0.5);
  EXPECT_GT(seen["angry"][Tension], seen["relaxed"][Tension] + 0.3);
  EXPECT_LT(seen["tired"][Stability], seen["normal"][Stability]);
}

}  // namespace
}  // namespace mien::pipeline
