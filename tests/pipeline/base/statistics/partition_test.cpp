#include "pipeline/base/statistics/partition.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Linkage five_points() {
  Eigen::MatrixXd points(5, 2);
  points << 0, 0, 1, 0, 4, 0, 4, 3, 10, 0;
  return ward(points);
}

Partition random_partition(int things, int groups, std::mt19937& random) {
  Partition partition;
  std::uniform_int_distribution<int> group(0, groups - 1);
  for (int i = 0; i < things; ++i) partition.group.push_back(group(random));
  partition.groups = groups;
  return partition;
}

TEST(Partition, UndoesTheLastMerges) {
  const Linkage linkage = five_points();
  EXPECT_EQ(cut(linkage, 1).group, (std::vector<int>{0, 0, 0, 0, 0}));
  EXPECT_EQ(cut(linkage, 2).group, (std::vector<int>{0, 0, 0, 0, 1}));
  EXPECT_EQ(cut(linkage, 3).group, (std::vector<int>{0, 0, 1, 1, 2}));
  EXPECT_EQ(cut(linkage, 5).group, (std::vector<int>{0, 1, 2, 3, 4}));
  for (int clusters = 1; clusters <= 5; ++clusters) {
    EXPECT_EQ(cut(linkage, clusters).groups, clusters);
  }
}

TEST(Partition, NumbersGroupsAlongTheDendrogram) {
  // 0 and 3 are near each other and far from 1 and 2: the leaves stand 0 3 1 2.
  const Linkage linkage = ward(Eigen::Vector4d(0.0, 10.0, 11.0, 0.5));
  EXPECT_EQ(leaf_order(linkage), (std::vector<int>{0, 3, 1, 2}));
  EXPECT_EQ(cut(linkage, 3).group, (std::vector<int>{0, 1, 2, 0}));
}

TEST(Partition, TheWidestGapSuggestsThePlainGroups) {
  // Three far groups of near points: heights rise slowly, then leap.
  Eigen::VectorXd points(9);
  points << 0, 1, 2, 100, 101, 102, 200, 201, 202;
  EXPECT_EQ(clusters_by_largest_gap(ward(points)), 3);
  // Heights 1, 3, 5.39, 9.85: the last step is the widest.
  EXPECT_EQ(clusters_by_largest_gap(five_points()), 2);
  EXPECT_EQ(clusters_by_largest_gap(ward(Eigen::Vector2d(0, 1))), 2);
  EXPECT_EQ(clusters_by_largest_gap(ward(Eigen::VectorXd::Zero(1))), 1);
}

TEST(Partition, TheCutLiesBetweenWhatItKeepsAndUndoes) {
  const Linkage linkage = five_points();
  for (int clusters = 1; clusters <= 5; ++clusters) {
    const double height = cut_height(linkage, clusters);
    int below = 0;
    for (const Merge& merge : linkage.merges) below += merge.height < height;
    EXPECT_EQ(below, 5 - clusters);
  }
}

TEST(Partition, RandIndexCountsPairsByDefinition) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Partition a = random_partition(23, 1 + trial % 5, random);
    const Partition b = random_partition(23, 1 + trial % 4, random);
    int agreeing = 0;
    int pairs = 0;
    for (size_t i = 0; i < 23; ++i) {
      for (size_t k = 0; k < i; ++k) {
        ++pairs;
        agreeing += (a.group[i] == a.group[k]) == (b.group[i] == b.group[k]);
      }
    }
    EXPECT_NEAR(rand_index(a, b), agreeing / static_cast<double>(pairs), 1e-12);
    EXPECT_NEAR(rand_index(a, b), rand_index(b, a), 1e-15);
    EXPECT_NEAR(adjusted_rand_index(a, b), adjusted_rand_index(b, a), 1e-15);
  }
}

TEST(Partition, AdjustedRandIndexMatchesScikitLearnsExamples) {
  EXPECT_NEAR(adjusted_rand_index({{0, 0, 1, 2}, 3}, {{0, 0, 1, 1}, 2}), 0.57142857, 1e-8);
  EXPECT_NEAR(adjusted_rand_index({{0, 0, 1, 1}, 2}, {{0, 1, 0, 1}, 2}), -0.5, 1e-12);
  EXPECT_NEAR(adjusted_rand_index({{0, 0, 0, 0}, 1}, {{0, 1, 2, 3}, 4}), 0.0, 1e-12);
}

TEST(Partition, IndicesAreOneForTheSameGroupsByAnyNumbers) {
  const Partition a = {{0, 0, 1, 1, 2}, 3};
  const Partition b = {{2, 2, 0, 0, 1}, 3};
  EXPECT_DOUBLE_EQ(rand_index(a, b), 1.0);
  EXPECT_DOUBLE_EQ(adjusted_rand_index(a, b), 1.0);
  EXPECT_DOUBLE_EQ(adjusted_rand_index({{0, 0}, 1}, {{0, 0}, 1}), 1.0);
  EXPECT_DOUBLE_EQ(adjusted_rand_index({{}, 0}, {{}, 0}), 1.0);
}

TEST(Partition, AdjustedRandIndexOfUnrelatedPartitionsIsNoughtOnAverage) {
  std::mt19937 random(8);
  double sum = 0.0;
  constexpr int trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    sum += adjusted_rand_index(random_partition(30, 4, random), random_partition(30, 3, random));
  }
  // Its standard deviation here is about 0.04.
  EXPECT_NEAR(sum / trials, 0.0, 5.0 * 0.04 / std::sqrt(trials));
}

}  // namespace
}  // namespace mien::pipeline
