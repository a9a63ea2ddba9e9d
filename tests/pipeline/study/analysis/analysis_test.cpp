#include "pipeline/study/analysis/analysis.h"

#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/study/analysis/analysis_report.h"
#include "pipeline/study/analysis/scales_yaml.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

/// Six scales in three pairs, each pair answering alike; one further scale that is always neutral.
ScaleSet seven_scales() {
  ScaleSet set;
  set.name = "test";
  for (const char* id : {"slow-fast", "dull-quick", "sad-happy", "dark-bright", "small-large",
                         "narrow-wide", "hard-soft"}) {
    const std::string text = id;
    const size_t hyphen = text.find('-');
    set.scales.push_back(
        {.id = text, .low = text.substr(0, hyphen), .high = text.substr(hyphen + 1)});
  }
  set.groups.push_back({"pace", "速さ", {"slow-fast", "dull-quick"}});
  set.groups.push_back({"mood", "", {"sad-happy", "dark-bright", "hard-soft"}});
  return set;
}

const std::vector<RatedExample> four_examples = {{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}};

StudyAnswers seven_answers(double strength = 1.0) {
  // Means by example of the three pairs and of the neutral scale.
  constexpr double means[4][4] = {{-2, -1, 1, 2}, {2, -1, -2, 1}, {0, 2, -1, -1}, {0, 0, 0, 0}};
  StudyAnswers study;
  const ScaleSet scales = seven_scales();
  for (int r = 0; r < 4; ++r) {
    for (size_t i = 0; i < 4; ++i) {
      for (size_t j = 0; j < 7; ++j) {
        // Two raters above and two below by as much; the second scale of a pair is a little milder.
        const double answer = strength * means[j / 2][i] * (j % 2 == 0 ? 1.0 : 0.9);
        StudyAnswer given;
        given.participant = "p" + std::to_string(r);
        given.stimulus = four_examples[i].name;
        given.scale = scales.scales[j].id;
        given.value = std::clamp(answer + (r % 2 == 0 ? 0.25 : -0.25), -2.0, 2.0);
        study.answers.push_back(given);
      }
    }
  }
  return study;
}

TEST(Analysis, ClustersTheKeptScalesAndNamesThemAfterTheGroups) {
  const ScaleSet scales = seven_scales();
  const Analysis a = analyse(seven_answers(), scales, four_examples, {.clusters = 3});
  EXPECT_FALSE(a.none_retained);
  EXPECT_EQ(a.clustered, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(a.quantities[6].neutral);
  ASSERT_EQ(a.clusters.size(), 3u);
  EXPECT_EQ(a.clusters[0].name, "pace");
  EXPECT_EQ(a.clusters[0].japanese, "速さ");
  EXPECT_EQ(a.clusters[1].name, "mood");
  EXPECT_EQ(a.clusters[2].name, "cluster-3");
  EXPECT_EQ(a.suggested_clusters, 3);
  EXPECT_EQ(central_words(a, a.clusters[1], scales, 5), "happy, bright");
  // A′ is the mean of the members' rows.
  EXPECT_LT(
      (a.clusters[1].mean - 0.5 * (a.impressions.mean.row(2) + a.impressions.mean.row(3))).norm(),
      1e-12);
  EXPECT_TRUE(a.warnings.empty());
}

TEST(Analysis, TakesGivenNamesAndRefusesBadOnes) {
  const ScaleSet scales = seven_scales();
  const auto names = [&](std::vector<std::string> given) {
    try {
      const Analysis a = analyse(seven_answers(), scales, four_examples,
                                 {.clusters = 3, .names = std::move(given)});
      return a.clusters[0].name + a.clusters[1].name + a.clusters[2].name;
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(names({"x", "y", "z"}), "xyz");
  EXPECT_EQ(names({"x", "y"}),
            "--names: 2 names for 3 clusters; give one name for each cluster, for example "
            "--names pace,size");
  EXPECT_EQ(names({"x", "y", "x"}).rfind("--names: \"x\" appears twice", 0), 0u);
  EXPECT_EQ(names({"x", "y", "sad-happy"}).rfind("--names: \"sad-happy\" is a scale", 0), 0u);
}

TEST(Analysis, GoesOnWithAllScalesWhenNoneIsKept) {
  const ScaleSet scales = seven_scales();
  const Analysis a = analyse(seven_answers(0.4), scales, four_examples, {.clusters = 3});
  EXPECT_TRUE(a.none_retained);
  EXPECT_EQ(a.clustered.size(), 7u);
  ASSERT_TRUE(a.suggested);
  int retained = 0;
  for (const Quantity& q : quantify(a.impressions, scales, *a.suggested)) retained += q.retained();
  EXPECT_GE(retained, 4);
  ASSERT_EQ(a.warnings.size(), 1u);
  EXPECT_EQ(a.warnings[0].kind, "thresholds");
  EXPECT_NE(a.warnings[0].text.find("--max-mean 0.7"), std::string::npos) << a.warnings[0].text;
  EXPECT_NE(clusters_table(a).csv.find(",all\n"), std::string::npos);
}

TEST(Analysis, MakesAsManyClustersAsThereAreScalesAtMost) {
  const Analysis a = analyse(seven_answers(), seven_scales(), four_examples, {.clusters = 20});
  EXPECT_EQ(a.clusters.size(), 6u);
  ASSERT_EQ(a.warnings.size(), 1u);
  EXPECT_EQ(a.warnings[0].kind, "clusters");
}

TEST(Analysis, TheOrderOfTheExamplesAndAnswersChangesNothing) {
  const ScaleSet scales = seven_scales();
  const std::string before = linkage_table(analyse(seven_answers(), scales, four_examples, {})).csv;
  std::vector<RatedExample> turned(four_examples.rbegin(), four_examples.rend());
  StudyAnswers shuffled = seven_answers();
  std::mt19937 random(1);
  std::shuffle(shuffled.answers.begin(), shuffled.answers.end(), random);
  const Analysis after = analyse(shuffled, scales, turned, {});
  const Analysis first = analyse(seven_answers(), scales, four_examples, {});
  ASSERT_EQ(after.linkage.merges.size(), first.linkage.merges.size());
  for (size_t k = 0; k < first.linkage.merges.size(); ++k) {
    EXPECT_EQ(after.linkage.merges[k].members, first.linkage.merges[k].members);
    EXPECT_NEAR(after.linkage.merges[k].height, first.linkage.merges[k].height, 1e-12);
  }
}

TEST(Analysis, WritesTablesThatReadBack) {
  const ScaleSet scales = seven_scales();
  const Analysis a = analyse(seven_answers(), scales, four_examples, {.clusters = 3});
  const test::TemporaryFolder folder;
  write_analysis(a, scales, {}, folder.path() / "deep" / "results");
  const auto rows = [&](const std::string& name) {
    return read_csv(folder.path() / "deep" / "results" / name).rows.size();
  };
  EXPECT_EQ(rows("quantification.csv"), 7u);
  EXPECT_EQ(rows("thresholds.csv"), 82u);
  EXPECT_EQ(rows("impressions.csv"), 28u);
  EXPECT_EQ(rows("linkage.csv"), 5u);
  EXPECT_EQ(rows("clusters.csv"), 6u);
  EXPECT_EQ(rows("primary.csv"), 12u);
  EXPECT_EQ(rows("agreement.csv"), 7u);
  EXPECT_EQ(rows("warnings.csv"), 0u);
  for (const char* name : {"dendrogram.pdf", "dendrogram.svg", "dendrogram.png"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() / "deep" / "results" / name), 1000u);
  }
  // The scales file makes the clusters parameters whose values are A′.
  const ScaleSet clustered = read_scales(folder.path() / "deep" / "results/clusters.scales.yaml");
  ASSERT_EQ(clustered.groups.size(), 3u);
  EXPECT_EQ(clustered.scales.size(), 7u);
  const ParameterTable parameters = parameter_table(a.impressions, clustered);
  for (const ScaleCluster& cluster : a.clusters) {
    const int row = parameters.find(cluster.name);
    ASSERT_GE(row, 0) << cluster.name;
    EXPECT_LT((parameters.values.row(row) - cluster.mean).norm(), 1e-12);
  }
}

TEST(Analysis, TablesSayWhoseRatingsTheyRestOn) {
  const ScaleSet scales = seven_scales();
  StudyAnswers study = seven_answers();
  for (const bool simulated : {false, true}) {
    study.simulated = simulated;
    const Analysis a = analyse(study, scales, four_examples, {});
    for (const std::string& csv :
         {quantification_table(a, scales).csv, thresholds_table(a, scales, {}).csv,
          impressions_csv(a.impressions, scales), linkage_table(a).csv, clusters_table(a).csv,
          primary_table(a).csv, agreement_table(a).csv}) {
      const CsvTable table = parse_csv(csv, "t.csv");
      const int column = require_column(table, "ratings");
      for (const auto& row : table.rows) {
        EXPECT_EQ(row[static_cast<size_t>(column)].text, simulated ? "simulated" : "given");
      }
    }
  }
}

TEST(Analysis, RealRatingsOfThirtyWalksAreTooDisputedForTheUsualThresholds) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no real data; set MIEN_DATA";
  const auto mocap = *data / "mocap" / "bandai-namco-1";
  const ScaleSet scales =
      read_scales(std::string(MIEN_SOURCE_DIR) + "/manifests/five-factors.scales.yaml");
  std::vector<RatedExample> walks;
  for (const auto& entry : std::filesystem::directory_iterator(mocap)) {
    const std::string stem = entry.path().stem().string();
    if (stem.find("_walk_") != std::string::npos) walks.push_back({stem, stem});
  }
  ASSERT_EQ(walks.size(), 30u);
  const StudyAnswers study = read_study_answers(mocap / "ratings.csv", scales, walks,
                                                {.unknown = AnswerRules::Unknown::ignore});
  const Analysis a = analyse(study, scales, walks, {});
  EXPECT_EQ(a.quantities.size(), 5u);
  EXPECT_TRUE(a.none_retained);
  ASSERT_TRUE(a.suggested);
  int retained = 0;
  for (const Quantity& q : quantify(a.impressions, scales, *a.suggested)) retained += q.retained();
  EXPECT_GE(retained, 3);
  EXPECT_EQ(a.clusters.size(), 4u);
  for (const Agreement& agreement : a.agreements) {
    EXPECT_GT(agreement.all.answers_per_stimulus, 14.0);
    EXPECT_LT(agreement.all.one_k, 1.0);
  }
}

}  // namespace
}  // namespace mien::pipeline
