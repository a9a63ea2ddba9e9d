#include "motion/skeleton/straighten.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/gait/loop.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

TEST(Straighten, WalksAlongZFromTheOriginWhereverOneHeaded) {
  SyntheticWalk walk = steady_walk(1.2, 2.0);
  const Clip reference = straightened(synthetic_clip(walk));
  for (const double yaw : {0.4, 1.9, -2.8}) {
    walk.heading = yaw;
    Clip clip = synthetic_clip(walk);
    for (Pose& pose : clip.poses) pose.root_position += Vec3(3, 0, -7);
    const Clip straight = straightened(clip);
    EXPECT_NEAR(straight.poses.front().root_position.x(), 0.0, 1e-9);
    EXPECT_NEAR(straight.poses.front().root_position.z(), 0.0, 1e-9);
    EXPECT_NEAR((mean_direction(straight) - Vec3::UnitZ()).norm(), 0.0, 1e-9);
    const auto a = joint_paths(reference);
    const auto b = joint_paths(straight);
    for (size_t t = 0; t < a.size(); t += 20) {
      for (int j = 0; j < body_joint_count; ++j) EXPECT_NEAR((a[t][j] - b[t][j]).norm(), 0, 1e-9);
    }
  }
}

TEST(Straighten, TurnsAStandingFigureToFaceForward) {
  SyntheticWalk still;
  still.distance.assign(50, 0.3);
  still.heading = 1.2;
  const Clip straight = straightened(synthetic_clip(still));
  const Vec3 facing = straight.poses.front().rotations[Pelvis] * Vec3::UnitZ();
  EXPECT_NEAR((facing - Vec3::UnitZ()).norm(), 0.0, 1e-9);
}

TEST(Straighten, PutsALoopOnTheMiddleLine) {
  SyntheticWalk walk = steady_walk(1.2, 3.0);
  walk.heading = 0.7;
  Clip clip = synthetic_clip(walk);
  for (size_t t = 0; t < clip.poses.size(); ++t) {
    clip.poses[t].root_position.x() += 0.05 * std::sin(2 * pi * static_cast<double>(t) / 100.0);
  }
  const Clip loop = straightened(closed_loop(clip, 100, 200));
  double sideways = 0.0;
  for (const Pose& pose : loop.poses) sideways += pose.root_position.x() / loop.frame_count();
  EXPECT_NEAR(sideways, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(loop.cycle_displacement.x(), 0.0);
  EXPECT_NEAR(loop.cycle_displacement.z(), 1.2, 0.01);
}

TEST(InPlace, StaysAndComesBackByTravelling) {
  const Clip loop = straightened(closed_loop(synthetic_clip(steady_walk(1.2, 3.0)), 100, 200));
  const Clip still = in_place(loop);
  EXPECT_TRUE(still.cycle_displacement.isZero());
  for (const Pose& pose : still.poses) EXPECT_LT(std::abs(pose.root_position.z()), 0.02);
  const Clip again = travelling(still, loop.cycle_displacement);
  for (size_t t = 0; t < loop.poses.size(); ++t) {
    EXPECT_NEAR((again.poses[t].root_position - loop.poses[t].root_position).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(again.cycle_displacement, loop.cycle_displacement);
}

/// Walks along +Z, turns round and comes back to where it began.
Clip there_and_back() {
  SyntheticWalk walk = steady_walk(1.2, 10.0);
  walk.turn_start = 5.0;
  walk.turn_length = 2.0;
  walk.turn_angle = pi;
  return synthetic_clip(walk);
}

double farthest_from_start(const Clip& clip) {
  double farthest = 0.0;
  for (const Pose& pose : clip.poses) {
    farthest = std::max(farthest,
                        horizontal(pose.root_position - clip.poses.front().root_position).norm());
  }
  return farthest;
}

TEST(KeptInPlace, StaysThoughItReturns) {
  const Clip clip = there_and_back();
  ASSERT_GT(farthest_from_start(clip), 4.0);
  const Clip kept = kept_in_place(clip);
  EXPECT_LT(farthest_from_start(kept), 0.3);
  for (size_t t = 0; t < clip.poses.size(); t += 50) {
    EXPECT_EQ(kept.poses[t].root_position.y(), clip.poses[t].root_position.y());
    EXPECT_EQ(kept.poses[t].rotations[Pelvis].coeffs(), clip.poses[t].rotations[Pelvis].coeffs());
  }
}

TEST(KeptInPlace, KeepsTheSurgeOfAStraightWalk) {
  Clip clip = synthetic_clip(steady_walk(1.2, 4.0));
  for (int t = 0; t < clip.frame_count(); ++t) {
    clip.poses[t].root_position.z() += 0.03 * std::sin(2 * pi * 0.5 * t / 100.0);
  }
  const Clip kept = kept_in_place(clip);
  for (int t = 0; t < clip.frame_count(); ++t) {
    EXPECT_NEAR(kept.poses[t].root_position.z(), 0.03 * std::sin(2 * pi * 0.5 * t / 100.0), 1e-9);
  }
}

TEST(Resampling, EndsWithinTheMotion) {
  // 10.6 and 10.4 steps of 1/30 s: the next frame would lie beyond the end.
  for (const int frames : {36, 35, 31, 2}) {
    Clip clip = synthetic_clip(steady_walk(1.2, 2.0));
    clip.poses.resize(static_cast<size_t>(frames));
    const Clip slow = resampled(clip, 30.0);
    EXPECT_LE(slow.duration_seconds(), std::max(clip.duration_seconds(), 1.0 / 30.0) + 1e-9);
    EXPECT_GT(slow.duration_seconds(), clip.duration_seconds() - 1.0 / 30.0);
  }
  Clip pose = synthetic_clip(steady_walk(1.2, 1.0));
  pose.poses.resize(1);
  EXPECT_EQ(resampled(pose, 30.0).frame_count(), 1);
}

}  // namespace
}  // namespace mien::motion
