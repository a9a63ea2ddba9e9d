#include "motion/motion_graph/distance_minima.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "made_motions.h"

namespace mien::motion {
namespace {

using test::made_motions;

constexpr int window_frames = 10;

std::vector<PointCloud> clouds_of(const std::vector<std::size_t>& clips) {
  std::vector<PointCloud> clouds;
  for (const std::size_t clip : clips) clouds.push_back(point_cloud(made_motions()[clip]));
  return clouds;
}

/// All distances of the windows of two clouds, one by one.
Eigen::MatrixXd all_distances(const PointCloud& a, const PointCloud& b) {
  Eigen::MatrixXd distances(a.frame_count() - window_frames + 1,
                            b.frame_count() - window_frames + 1);
  for (int i = 0; i < distances.rows(); ++i) {
    for (int j = 0; j < distances.cols(); ++j) {
      distances(i, j) = window_distance(a, i, b, j, window_frames).metres;
    }
  }
  return distances;
}

bool is_minimum(const Eigen::MatrixXd& distances, int i, int j) {
  for (int r = std::max(0, i - 1);
       r <= std::min<int>(i + 1, static_cast<int>(distances.rows()) - 1); ++r) {
    for (int c = std::max(0, j - 1);
         c <= std::min<int>(j + 1, static_cast<int>(distances.cols()) - 1); ++c) {
      if ((r != i || c != j) && distances(r, c) <= distances(i, j)) return false;
    }
  }
  return true;
}

TEST(DistanceMinima, AreThoseOfTheDistancesOneByOne) {
  const std::vector<PointCloud> clouds = clouds_of({1, 4});
  MinimaOptions options;
  options.window = window_frames;
  const std::vector<DistanceMinimum> minima = distance_minima(clouds, options);
  const Eigen::MatrixXd distances = all_distances(clouds[0], clouds[1]);
  int expected = 0;
  for (int i = 0; i < distances.rows(); ++i) {
    for (int j = 0; j < distances.cols(); ++j) expected += is_minimum(distances, i, j);
  }
  int found = 0;
  for (const DistanceMinimum& m : minima) {
    if (m.clip_a == m.clip_b) continue;
    ++found;
    EXPECT_TRUE(is_minimum(distances, m.frame_a, m.frame_b));
    EXPECT_NEAR(m.metres, distances(m.frame_a, m.frame_b), 1e-7);
  }
  EXPECT_GT(found, 10);
  EXPECT_EQ(found, expected);
}

TEST(DistanceMinima, AreTheSameAcrossTilesAndThreads) {
  // Longer than a tile: minima at its borders are seen from both sides.
  Clip longer = made_motions()[1];
  while (longer.frame_count() < 600) {
    const std::vector<Pose>& more = made_motions()[4].poses;
    longer.poses.insert(longer.poses.end(), more.begin(), more.end());
  }
  const std::vector<PointCloud> clouds = {point_cloud(longer)};
  MinimaOptions options;
  options.window = window_frames;
  options.threads = 1;
  const std::vector<DistanceMinimum> one = distance_minima(clouds, options);
  options.threads = 3;
  const std::vector<DistanceMinimum> three = distance_minima(clouds, options);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t m = 0; m < one.size(); ++m) {
    EXPECT_EQ(one[m].frame_a, three[m].frame_a);
    EXPECT_EQ(one[m].metres, three[m].metres);
  }
  for (const DistanceMinimum& m : one) {
    EXPECT_GE(m.frame_b, m.frame_a + options.least_gap);
    EXPECT_NEAR(m.metres,
                window_distance(clouds[0], m.frame_a, clouds[0], m.frame_b, window_frames).metres,
                1e-6);
  }
}

}  // namespace
}  // namespace mien::motion
