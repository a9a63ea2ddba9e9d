#include "motion/motion_graph/point_cloud.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/random_number.h"

#include "made_motions.h"

namespace mien::motion {
namespace {

using test::made_motions;
using test::moved;

constexpr int window = 10;

/// Mean squared distance of the points with equal weights, the second motion moved by an alignment.
double squared_after(const Clip& a, int first_a, const Clip& b, int first_b,
                     const PlaneAlignment& alignment) {
  const auto points = [](const Clip& clip, int frame) {
    const PointCloud cloud = point_cloud(clip);
    const auto count = cloud.up.rows();
    std::vector<Vec3> places;
    const double scale = std::sqrt(static_cast<double>(count));
    for (Eigen::Index p = 0; p < count; ++p) {
      places.push_back(
          scale * Vec3(cloud.level(p, frame), cloud.up(p, frame), cloud.level(count + p, frame)));
    }
    return places;
  };
  double sum = 0.0;
  for (int f = 0; f < window; ++f) {
    const std::vector<Vec3> of_a = points(a, first_a + f);
    const std::vector<Vec3> of_b = points(b, first_b + f);
    for (std::size_t p = 0; p < of_a.size(); ++p) {
      sum += (of_a[p] - aligned(alignment, of_b[p])).squaredNorm() /
             (window * static_cast<double>(of_a.size()));
    }
  }
  return sum;
}

Clip part(const Clip& clip, int first) {
  Clip some = clip;
  some.poses.assign(clip.poses.begin() + first, clip.poses.begin() + first + window);
  return some;
}

TEST(PointCloud, AWindowIsAtNoDistanceFromItselfWhereverItStands) {
  const Clip& walk = made_motions()[2];
  const Clip elsewhere = moved(walk, 2.3, Vec3(5, 0, -3));
  const WindowDistance distance =
      window_distance(point_cloud(walk), 20, point_cloud(elsewhere), 20, window);
  EXPECT_NEAR(distance.metres, 0.0, 1e-6);
  EXPECT_NEAR(std::remainder(distance.alignment.turn + 2.3, 2.0 * pi), 0.0, 1e-9);
  const Vec3 back = aligned(distance.alignment, elsewhere.poses[25].root_position);
  EXPECT_LT((back - walk.poses[25].root_position).norm(), 1e-9);
}

TEST(PointCloud, TheDistanceIsTheSameBothWaysRound) {
  const PointCloud a = point_cloud(made_motions()[1]);
  const PointCloud b = point_cloud(made_motions()[5]);
  for (int i = 0; i < 40; i += 7) {
    EXPECT_NEAR(window_distance(a, i, b, 60 - i, window).metres,
                window_distance(b, 60 - i, a, i, window).metres, 1e-9);
  }
}

TEST(PointCloud, NoOtherAlignmentIsBetter) {
  const Clip a = part(made_motions()[1], 40);
  const Clip b = moved(part(made_motions()[4], 55), -1.1, Vec3(-2, 0, 0.4));
  const WindowDistance best = window_distance(point_cloud(a), 0, point_cloud(b), 0, window);
  const double least = squared_after(a, 0, b, 0, best.alignment);
  EXPECT_NEAR(std::sqrt(least), best.metres, 1e-9);
  for (std::uint64_t n = 0; n < 60; ++n) {
    const double size = n % 2 == 0 ? 0.02 : 0.5;
    PlaneAlignment other = best.alignment;
    other.turn += size * random_number(1, "turn", n);
    other.x += size * random_number(1, "x", n);
    other.z += size * random_number(1, "z", n);
    EXPECT_GE(squared_after(a, 0, b, 0, other), least - 1e-12);
  }
}

TEST(PointCloud, ATwistAboutABoneCounts) {
  const Clip& a = made_motions()[0];
  Clip b = a;
  for (Pose& pose : b.poses) {
    pose.rotations[LeftWrist] =
        pose.rotations[LeftWrist] * Quat(Eigen::AngleAxisd(1.0, Vec3::UnitX()));
  }
  EXPECT_GT(window_distance(point_cloud(a), 0, point_cloud(b), 0, window).metres, 0.01);
  CloudOptions without;
  without.virtual_point_m = 0.0;
  EXPECT_NEAR(
      window_distance(point_cloud(a, without), 0, point_cloud(b, without), 0, window).metres, 0.0,
      1e-6);
}

TEST(PointCloud, WhatWeighsNothingDoesNotCount) {
  const Clip& a = made_motions()[0];
  Clip b = a;
  for (Pose& pose : b.poses) {
    pose.rotations[LeftElbow] = Quat(Eigen::AngleAxisd(-1.2, Vec3::UnitY()));
  }
  CloudOptions options;
  options.joint_weights[LeftElbow] = options.joint_weights[LeftWrist] = 0.0;
  EXPECT_NEAR(
      window_distance(point_cloud(a, options), 0, point_cloud(b, options), 0, window).metres, 0.0,
      1e-6);
  EXPECT_GT(window_distance(point_cloud(a), 0, point_cloud(b), 0, window).metres, 0.02);
}

}  // namespace
}  // namespace mien::motion
