#include "motion/motion_graph/graph_walk.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait/foot_lock.h"
#include "motion/lint/lint.h"
#include "motion/modify/modification.h"

#include "made_motions.h"
#include "random_walk.h"

namespace mien::motion {
namespace {

using test::largest_acceleration;
using test::made_graph;
using test::made_motions;
using test::random_walk;

double facing(const Pose& pose) {
  const Vec3 forward = pose.rotations.front() * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z());
}

/// Longest step and largest turn, over the floor, that a frame of the walk's clips makes.
struct Stride {
  double metres = 0.0;
  double radians = 0.0;
};

Stride stride_in(const MotionGraph& graph, int clip, int frame) {
  const std::vector<Pose>& poses = graph.clips[static_cast<std::size_t>(clip)].poses;
  const auto to = static_cast<std::size_t>(std::max(frame, 1));
  return {horizontal(poses[to].root_position - poses[to - 1].root_position).norm(),
          std::abs(std::remainder(facing(poses[to]) - facing(poses[to - 1]), 2.0 * pi))};
}

TEST(GraphWalk, TheRootGoesOnAsItsMotionsDo) {
  const MotionGraph& graph = made_graph();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const GraphWalk walk = random_walk(graph, 60.0, seed);
    const std::vector<WalkFrame> frames = frames_of(graph, walk);
    const Clip clip = motion_of(graph, walk);
    ASSERT_EQ(clip.poses.size(), frames.size());
    for (std::size_t f = 1; f < frames.size(); ++f) {
      Stride most = stride_in(graph, frames[f].clip, frames[f].frame);
      if (frames[f].to_clip >= 0) {
        const Stride other = stride_in(graph, frames[f].to_clip, frames[f].to_frame);
        most = {std::max(most.metres, other.metres), std::max(most.radians, other.radians)};
      }
      const Vec3 step = horizontal(clip.poses[f].root_position - clip.poses[f - 1].root_position);
      EXPECT_LT(step.norm(), most.metres + 0.001) << "frame " << f << " of seed " << seed;
      const double turn =
          std::abs(std::remainder(facing(clip.poses[f]) - facing(clip.poses[f - 1]), 2.0 * pi));
      EXPECT_LT(turn, most.radians + radians_per_degree) << "frame " << f << " of seed " << seed;
    }
  }
}

TEST(GraphWalk, AMinuteAtRandomNeitherSkatesNorPops) {
  const MotionGraph& graph = made_graph();
  double source = 0.0;
  for (const Clip& clip : graph.clips) source = std::max(source, largest_acceleration(clip));
  for (const std::uint64_t seed : {1, 2, 3}) {
    const GraphWalk walk = random_walk(graph, 60.0, seed);
    const Clip clip = motion_of(graph, walk);
    EXPECT_GE(clip.duration_seconds(), 59.9);
    EXPECT_LT(planted_drift(clip, plants_of(graph, frames_of(graph, walk))), 0.005);
    EXPECT_LT(largest_acceleration(clip), 1.2 * source);
    for (const Finding& finding : lint(clip)) {
      EXPECT_NE(finding.severity, Severity::error) << finding.sentence;
    }
  }
}

TEST(GraphWalk, WithoutTransitionsItIsTheClip) {
  const MotionGraph& graph = made_graph();
  GraphWalk walk;
  for (std::size_t e = 0; e < graph.edges.size() && walk.edges.size() < 5; ++e) {
    const bool follows =
        walk.edges.empty() ||
        graph.edges[static_cast<std::size_t>(walk.edges.back())].to == graph.edges[e].from;
    if (graph.edges[e].transition < 0 && follows) walk.edges.push_back(static_cast<int>(e));
  }
  const GraphNode& start = graph.nodes[static_cast<std::size_t>(
      graph.edges[static_cast<std::size_t>(walk.edges[0])].from)];
  const Clip& source = graph.clips[static_cast<std::size_t>(start.clip)];
  const Pose& first = source.poses[static_cast<std::size_t>(start.frame)];
  GraphWalkOptions options;
  options.place = first.root_position;
  options.heading = facing(first);
  const Clip clip = motion_of(graph, walk, options);
  for (std::size_t f = 0; f < clip.poses.size(); ++f) {
    const Pose& expected = source.poses[static_cast<std::size_t>(start.frame) + f];
    EXPECT_LT((clip.poses[f].root_position - expected.root_position).norm(), 1e-9);
    EXPECT_LT(clip.poses[f].rotations[Head].angularDistance(expected.rotations[Head]), 1e-9);
  }
}

TEST(GraphWalk, IsOfItsSeedAlone) {
  const MotionGraph& graph = made_graph();
  EXPECT_EQ(random_walk(graph, 20.0, 7).edges, random_walk(graph, 20.0, 7).edges);
  EXPECT_NE(random_walk(graph, 20.0, 7).edges, random_walk(graph, 20.0, 8).edges);
}

TEST(GraphWalk, AMoodChangesOnTheWay) {
  Modification droop;
  droop.posture = {{PostureUnit::head_flexion, 25.0}, {PostureUnit::chest_flexion, 10.0}};
  std::vector<SynchronisedMotion> bowed;
  for (const Clip& clip : made_graph().clips) {
    bowed.push_back({modified(clip, droop), {}});
    bowed.back().frame_seconds.assign(clip.poses.size(), 1.25 / clip.frames_per_second);
  }
  const std::vector<MotionGraph> versions = {made_graph(), with_motions(made_graph(), bowed)};
  const GraphWalk walk = random_walk(made_graph(), 12.0, 4);
  const std::vector<MoodChange> moods = {{0.0, {1.0, 0.0}}, {6.0, {0.0, 1.0}}};
  const Clip clip = motion_of(versions, walk, moods);
  const Clip upright = motion_of(made_graph(), walk);
  const auto face = [](const Clip& of, std::size_t frame) {
    const JointTransforms world = world_transforms(of.body, of.poses[frame]);
    return (world.rotations[Head] * Vec3::UnitZ()).y();
  };
  EXPECT_NEAR(face(clip, 150), face(upright, 150), 0.01);
  EXPECT_LT(face(clip, 240), face(upright, 220) - 0.3);
  // From the sixth second on everything takes a quarter longer.
  const double expected = 6.0 + 1.25 * (upright.duration_seconds() - 6.0);
  EXPECT_NEAR(clip.duration_seconds(), expected, 0.15);
  EXPECT_LT(largest_acceleration(clip), 1.5 * largest_acceleration(upright));
  EXPECT_THROW(motion_of(versions, walk, std::vector<MoodChange>{{0.0, {0.0, 0.0}}}), Error);
  const std::vector<MotionGraph> others = {made_graph(),
                                           motion_graph(std::vector<Clip>{made_motions()[2]})};
  EXPECT_THROW(motion_of(others, walk, {}), Error);
}

TEST(GraphWalk, RefusesLeapsAndNothing) {
  const MotionGraph& graph = made_graph();
  EXPECT_THROW(motion_of(graph, GraphWalk{}), Error);
  for (std::size_t e = 1; e < graph.edges.size(); ++e) {
    if (graph.edges[e].from == graph.edges[0].to) continue;
    EXPECT_THROW(motion_of(graph, GraphWalk{{0, static_cast<int>(e)}}), Error);
    break;
  }
}

}  // namespace
}  // namespace mien::motion
