#include "motion/motion_graph/guided_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait/foot_slide.h"
#include "motion/modify/modification.h"

#include "made_motions.h"

namespace mien::motion {
namespace {

using test::made_graph;
using test::made_motions;
using Kind = WalkSegment::Kind;

double farthest_beside(const std::vector<Vec3>& path, const Clip& clip) {
  double farthest = 0.0;
  for (const Pose& pose : clip.poses) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& point : path)
      nearest = std::min(nearest, (horizontal(pose.root_position) - point).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

std::vector<Vec3> circle(double radius) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    const double angle = 2.0 * pi * i / 400;
    points.emplace_back(radius * std::sin(angle), 0.0, radius - radius * std::cos(angle));
  }
  return points;
}

std::vector<Vec3> slalom() {
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) {
    points.emplace_back(0.6 * std::sin(4.0 * pi * i / 400), 0.0, 0.025 * i);
  }
  return points;
}

TEST(GuidedWalk, CirclesAndSlalomsAreFollowedWithin30Centimetres) {
  for (const std::vector<Vec3>& path : {circle(2.0), circle(4.0), slalom()}) {
    const Clip clip = walk_along(made_graph(), path).clip;
    EXPECT_LT(farthest_beside(path, clip), 0.3);
    EXPECT_LT((horizontal(clip.poses.back().root_position) - path.back()).norm(), 0.2);
  }
}

TEST(GuidedWalk, IsTheSameEveryTime) {
  const std::vector<Vec3> path = {{0, 0, 0}, {0, 0, 4}};
  EXPECT_EQ(walk_along(made_graph(), path).walk.edges, walk_along(made_graph(), path).walk.edges);
}

TEST(GuidedWalk, HasNoMoodUntilASegmentSetsOne) {
  Modification droop;
  droop.posture = {{PostureUnit::head_flexion, 25.0}, {PostureUnit::chest_flexion, 10.0}};
  std::vector<SynchronisedMotion> bowed;
  for (const Clip& clip : made_graph().clips) {
    bowed.push_back({modified(clip, droop), {}});
    bowed.back().frame_seconds.assign(clip.poses.size(), 1.0 / clip.frames_per_second);
  }
  const std::vector<MotionGraph> versions = {made_graph(), with_motions(made_graph(), bowed)};
  const std::vector<WalkSegment> script = {
      {.kind = Kind::walk, .seconds = 3.0},
      {.kind = Kind::walk, .seconds = 3.0, .moods = {0.0, 1.0}}};
  const Clip clip = scripted_walk(versions, script).clip;
  const auto face = [&](double seconds) {
    const auto frame = static_cast<std::size_t>(seconds * clip.frames_per_second);
    const JointTransforms world = world_transforms(clip.body, clip.poses[frame]);
    return (world.rotations[Head] * Vec3::UnitZ()).y();
  };
  for (const double seconds : {0.0, 1.0, 2.0}) EXPECT_GT(face(seconds), face(5.0) + 0.3) << seconds;
}

TEST(GuidedWalk, DoesWhatAScriptSays) {
  const std::vector<WalkSegment> script = {{.kind = Kind::walk, .seconds = 3.0},
                                           {.kind = Kind::turn, .degrees = 90.0, .pace = 0.0},
                                           {.kind = Kind::stand, .seconds = 1.5}};
  const Clip clip = scripted_walk(made_graph(), script).clip;
  EXPECT_NEAR(clip.duration_seconds(), 6.5, 0.5);
  const auto way = [&](std::size_t from, std::size_t to) {
    return horizontal(clip.poses[to].root_position - clip.poses[from].root_position).norm();
  };
  EXPECT_GT(way(30, 60), 1.0);
  const std::size_t last = clip.poses.size() - 1;
  EXPECT_LT(way(last - 20, last), 0.15);
  const Vec3 forward = clip.poses[last].rotations.front() * Vec3::UnitZ();
  EXPECT_NEAR(std::atan2(forward.x(), forward.z()) / radians_per_degree, 90.0, 35.0);
}

double heading_of(const Pose& pose) {
  const Vec3 forward = pose.rotations.front() * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z()) / radians_per_degree;
}

TEST(GuidedWalk, TurnsAsFarAsAScriptSaysAndStandsOnItsFeet) {
  for (const double degrees : {45.0, 90.0, -90.0, 135.0, 180.0}) {
    for (const double pace : {0.0, 1.0}) {
      const std::vector<WalkSegment> script = {
          {.kind = Kind::walk, .seconds = 3.0},
          {.kind = Kind::turn, .degrees = degrees, .pace = pace},
          {.kind = Kind::walk, .seconds = 2.0},
          {.kind = Kind::stand, .seconds = 1.0}};
      const GuidedWalk walk = scripted_walk(made_graph(), script);
      const double off = std::remainder(heading_of(walk.clip.poses.back()) - degrees, 360.0);
      EXPECT_LT(std::abs(off), 8.0) << degrees << "° at pace " << pace;
      EXPECT_FALSE(walk.missed.has_value()) << degrees << "° at pace " << pace;
      EXPECT_LT(planted_slide(walk.clip, walk.plants), 0.005);
      double source = 0.0;
      for (const Clip& clip : made_graph().clips)
        source = std::max(source, test::largest_acceleration(clip));
      EXPECT_LT(test::largest_acceleration(walk.clip), 1.1 * source);
    }
  }
}

TEST(GuidedWalk, TellsTheTurnThatStraightWalksDoNotMake) {
  const MotionGraph straight = motion_graph(std::vector<Clip>{made_motions()[2]});
  const std::vector<WalkSegment> script = {{.kind = Kind::walk, .seconds = 2.0},
                                           {.kind = Kind::turn, .degrees = 90.0},
                                           {.kind = Kind::walk, .seconds = 2.0}};
  const GuidedWalk walk = scripted_walk(straight, script);
  ASSERT_TRUE(walk.missed.has_value());
  EXPECT_EQ(walk.missed->segment, 1U);
  EXPECT_NEAR(walk.missed->degrees, 65.0, 10.0);
}

/// The search reckons with the versions' own steps: a path is followed in any mood.
TEST(GuidedWalk, FollowsAPathInAMixtureOfVersions) {
  std::vector<SynchronisedMotion> slow;
  for (const Clip& clip : made_graph().clips) {
    slow.push_back({clip, std::vector<double>(clip.poses.size(), 2.0 / clip.frames_per_second)});
  }
  const std::vector<MotionGraph> versions = {made_graph(), with_motions(made_graph(), slow)};
  const std::vector<MoodChange> moods = {{0.0, {1.0, 0.0}}, {4.0, {0.3, 0.7}}};
  for (const std::vector<Vec3>& path : {circle(2.0), circle(3.0), slalom()}) {
    const GuidedWalk walk = walk_along(versions, path, moods);
    EXPECT_LT(farthest_beside(path, walk.clip), 0.3);
    EXPECT_LT((horizontal(walk.clip.poses.back().root_position) - path.back()).norm(), 0.2);
  }
  const std::vector<Vec3> path = circle(3.0);
  const GuidedWalk walk = walk_along(versions, path, moods);
  EXPECT_GT(walk.clip.duration_seconds(),
            1.2 * walk_along(made_graph(), path).clip.duration_seconds());
}

TEST(GuidedWalk, StraightWalksCannotGoRound) {
  const MotionGraph straight = motion_graph(std::vector<Clip>{made_motions()[2]});
  EXPECT_THROW(walk_along(straight, circle(2.0)), Error);
}

TEST(GuidedWalk, RefusesWhatIsNoPathAndNoScript) {
  EXPECT_THROW(walk_along(made_graph(), std::vector<Vec3>{{0, 0, 0}}), Error);
  EXPECT_THROW(scripted_walk(made_graph(), std::vector<WalkSegment>{}), Error);
  GuidedWalkOptions options;
  options.kept_seconds = 9.0;
  EXPECT_THROW(walk_along(made_graph(), circle(2.0), options), Error);
}

}  // namespace
}  // namespace mien::motion
