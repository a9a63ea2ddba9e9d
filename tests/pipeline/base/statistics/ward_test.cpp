#include "pipeline/base/statistics/ward.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Eigen::MatrixXd random_rows(int rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Eigen::MatrixXd values(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index k = 0; k < columns; ++k) values(i, k) = share(random);
  }
  return values;
}

/// E of the paper's equation (5): squared distances of the members to their mean.
double sum_of_squares(const Eigen::MatrixXd& rows, const std::vector<int>& members) {
  const Eigen::MatrixXd own = rows(members, Eigen::all);
  return (own.rowwise() - own.colwise().mean()).squaredNorm();
}

std::vector<int> members_of(const Linkage& linkage, int cluster) {
  if (cluster < linkage.leaves) return {cluster};
  return linkage.merges[static_cast<size_t>(cluster - linkage.leaves)].members;
}

void expect_heights(const Eigen::MatrixXd& rows, const std::vector<double>& heights) {
  const Linkage linkage = ward(rows);
  ASSERT_EQ(linkage.merges.size(), heights.size());
  for (size_t k = 0; k < heights.size(); ++k) {
    EXPECT_NEAR(linkage.merges[k].height, heights[k], 1e-8) << k;
    EXPECT_NEAR(linkage.merges[k].increase, 0.5 * heights[k] * heights[k], 1e-7) << k;
  }
}

TEST(Ward, FivePointsMergeAtThePublishedHeights) {
  Eigen::MatrixXd points(5, 2);
  points << 0, 0, 1, 0, 4, 0, 4, 3, 10, 0;
  expect_heights(points, {1.0, 3.0, 5.38516481, 9.84885780});
  const Linkage linkage = ward(points);
  const std::vector<double> increases = {0.5, 4.5, 14.5, 48.5};
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(linkage.merges[k].increase, increases[k], 1e-12);
  }
  EXPECT_EQ(linkage.merges[0].members, (std::vector<int>{0, 1}));
  EXPECT_EQ(linkage.merges[1].members, (std::vector<int>{2, 3}));
  EXPECT_EQ(linkage.merges[2].members, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(linkage.merges[2].first, 5);
  EXPECT_EQ(linkage.merges[2].second, 6);
}

TEST(Ward, FourNumbersMergeAtThePublishedHeights) {
  expect_heights(Eigen::Vector4d(0, 1, 3, 7), {1.0, 2.88675135, 6.94022094});
}

TEST(Ward, FourCornersOfAGridMergeAsInScipysExample) {
  Eigen::MatrixXd points(12, 2);
  points << 0, 0, 0, 1, 1, 0, 0, 4, 0, 3, 1, 4, 4, 0, 3, 0, 4, 1, 4, 4, 3, 4, 4, 3;
  expect_heights(points, {1, 1, 1, 1, 1.29099445, 1.29099445, 1.29099445, 1.29099445, 5.77350269,
                          5.77350269, 8.16496581});
}

TEST(Ward, EqualPairsGoByTheirLowestVectors) {
  // 0 and 1, 2 and 3, 1 and 2 … are all one apart.
  const Linkage linkage = ward(Eigen::VectorXd::LinSpaced(4, 0.0, 3.0));
  EXPECT_EQ(linkage.merges[0].members, (std::vector<int>{0, 1}));
  EXPECT_EQ(linkage.merges[1].members, (std::vector<int>{2, 3}));
}

TEST(Ward, EveryMergeIsTheCheapestByDefinition) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::MatrixXd rows = random_rows(4 + static_cast<int>(seed), 5, seed);
    const Linkage linkage = ward(rows);
    std::set<int> clusters;
    for (int i = 0; i < linkage.leaves; ++i) clusters.insert(i);
    for (size_t step = 0; step < linkage.merges.size(); ++step) {
      double least = INFINITY;
      for (const int a : clusters) {
        for (const int b : clusters) {
          if (a >= b) continue;
          std::vector<int> both = members_of(linkage, a);
          const std::vector<int> other = members_of(linkage, b);
          both.insert(both.end(), other.begin(), other.end());
          least = std::min(least, sum_of_squares(rows, both) -
                                      sum_of_squares(rows, members_of(linkage, a)) -
                                      sum_of_squares(rows, members_of(linkage, b)));
        }
      }
      const Merge& merge = linkage.merges[step];
      EXPECT_NEAR(merge.increase, least, 1e-12) << "seed " << seed << " step " << step;
      ASSERT_EQ(clusters.erase(merge.first) + clusters.erase(merge.second), 2u);
      clusters.insert(linkage.leaves + static_cast<int>(step));
    }
  }
}

TEST(Ward, IncreasesNeverFallAndSumToTheTotal) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Eigen::MatrixXd rows = random_rows(60, 8, seed);
    const Linkage linkage = ward(rows);
    double sum = 0.0;
    double before = 0.0;
    for (const Merge& merge : linkage.merges) {
      EXPECT_GE(merge.increase, before - 1e-12);
      before = merge.increase;
      sum += merge.increase;
    }
    EXPECT_NEAR(sum, sum_of_squares(rows, linkage.merges.back().members), 1e-9);
  }
}

TEST(Ward, TheOrderOfTheExamplesChangesNothing) {
  std::mt19937 random(3);
  // Few different values, so that many merges tie.
  Eigen::MatrixXd rows = (4.0 * random_rows(40, 12, 7)).array().round() / 4.0;
  std::vector<int> order(12);
  for (int i = 0; i < 12; ++i) order[static_cast<size_t>(i)] = i;
  const Linkage expected = ward(rows);
  for (int trial = 0; trial < 10; ++trial) {
    std::shuffle(order.begin(), order.end(), random);
    const Eigen::MatrixXd shuffled = rows(Eigen::all, order);
    const Linkage linkage = ward(shuffled);
    for (size_t k = 0; k < expected.merges.size(); ++k) {
      ASSERT_EQ(linkage.merges[k].members, expected.merges[k].members) << k;
      EXPECT_NEAR(linkage.merges[k].increase, expected.merges[k].increase, 1e-12);
    }
  }
}

TEST(Ward, TurningEveryScaleRoundChangesNothing) {
  const Eigen::MatrixXd rows = random_rows(30, 9, 4);
  const Linkage expected = ward(rows);
  const Linkage mirrored = ward(Eigen::MatrixXd::Ones(30, 9) - rows);
  for (size_t k = 0; k < expected.merges.size(); ++k) {
    EXPECT_EQ(mirrored.merges[k].members, expected.merges[k].members);
    EXPECT_NEAR(mirrored.merges[k].height, expected.merges[k].height, 1e-12);
  }
}

TEST(Ward, LeafOrderHoldsEveryMergeTogether) {
  const Linkage linkage = ward(random_rows(50, 4, 11));
  const std::vector<int> order = leaf_order(linkage);
  ASSERT_EQ(order.size(), 50u);
  for (const Merge& merge : linkage.merges) {
    std::vector<long> places;
    for (const int member : merge.members) {
      places.push_back(std::ranges::find(order, member) - order.begin());
    }
    const auto [least, most] = std::ranges::minmax(places);
    EXPECT_EQ(most - least + 1, static_cast<long>(merge.members.size()));
  }
  EXPECT_EQ(order.front(), 0);
}

TEST(Ward, OfOneVectorOrNoneHasNoMerges) {
  EXPECT_TRUE(ward(Eigen::MatrixXd::Ones(1, 3)).merges.empty());
  EXPECT_EQ(leaf_order(ward(Eigen::MatrixXd::Ones(1, 3))), std::vector<int>{0});
  EXPECT_TRUE(ward(Eigen::MatrixXd(0, 3)).merges.empty());
  EXPECT_TRUE(leaf_order(ward(Eigen::MatrixXd(0, 3))).empty());
}

}  // namespace
}  // namespace mien::pipeline
