#include "motion/motion_graph/motion_graph.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/modify/modification.h"
#include "motion/motion_graph/graph_walk.h"
#include "motion/procedural/expressive_walks.h"
#include "motion/procedural/walker.h"

#include "made_motions.h"
#include "random_walk.h"

namespace mien::motion {
namespace {

using test::made_graph;
using test::made_motions;
using test::random_walk;

std::set<int> reached_from(const MotionGraph& graph, int start) {
  std::set<int> reached = {start};
  std::vector<int> open = {start};
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    for (const int edge : graph.leaving[static_cast<std::size_t>(node)]) {
      const int to = graph.edges[static_cast<std::size_t>(edge)].to;
      if (reached.insert(to).second) open.push_back(to);
    }
  }
  return reached;
}

std::string refusal_of(const std::vector<Clip>& clips, const MotionGraphOptions& options = {}) {
  try {
    motion_graph(clips, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(MotionGraph, EveryNodeIsReachedFromEveryOther) {
  const MotionGraph& graph = made_graph();
  ASSERT_GT(graph.nodes.size(), 100U);
  for (std::size_t n = 0; n < graph.nodes.size(); n += 37) {
    EXPECT_EQ(reached_from(graph, static_cast<int>(n)).size(), graph.nodes.size());
  }
}

TEST(MotionGraph, AllThatTheWalkerDoesIsInIt) {
  std::set<int> clips;
  for (const GraphNode& node : made_graph().nodes) clips.insert(node.clip);
  EXPECT_EQ(clips.size(), made_motions().size());
}

TEST(MotionGraph, TransitionsAreBelowTheThreshold) {
  const MotionGraph& graph = made_graph();
  std::vector<PointCloud> clouds;
  for (const Clip& clip : graph.clips) clouds.push_back(point_cloud(clip));
  for (const GraphTransition& t : graph.transitions) {
    EXPECT_LE(t.metres, graph.threshold_m);
    const WindowDistance distance =
        window_distance(clouds[static_cast<std::size_t>(t.from_clip)], t.from_frame,
                        clouds[static_cast<std::size_t>(t.to_clip)], t.to_frame, graph.window);
    EXPECT_EQ(distance.metres, t.metres);
  }
}

TEST(MotionGraph, ALoopGoesOnAsItself) {
  const Clip loop = walk(WalkStyle{}, 30.0, standard_body()).clip;
  const MotionGraph graph = motion_graph(std::vector<Clip>{loop});
  EXPECT_FALSE(graph.clips.front().loops);
  bool seamless = false;
  for (const GraphTransition& t : graph.transitions) {
    seamless = seamless || (t.from_frame == t.to_frame + loop.frame_count() && t.metres < 1e-6);
  }
  EXPECT_TRUE(seamless);
}

TEST(MotionGraph, TheNumberOfThreadsDoesNotMatter) {
  MotionGraphOptions options;
  options.threads = 1;
  const MotionGraph graph = motion_graph(made_motions(), options);
  ASSERT_EQ(graph.transitions.size(), made_graph().transitions.size());
  for (std::size_t t = 0; t < graph.transitions.size(); ++t) {
    EXPECT_EQ(graph.transitions[t].from_frame, made_graph().transitions[t].from_frame);
    EXPECT_EQ(graph.transitions[t].turn, made_graph().transitions[t].turn);
  }
}

TEST(MotionGraph, WhatCannotBeOneIsRefused) {
  EXPECT_NE(refusal_of({}).find("without motions"), std::string::npos);
  Clip slow = made_motions()[1];
  slow.frames_per_second = 25.0;
  EXPECT_NE(refusal_of({made_motions()[0], slow}).find("different frame rates"), std::string::npos);
  Clip tall = made_motions()[1];
  tall.body = standard_body(1.9);
  EXPECT_NE(refusal_of({made_motions()[0], tall}).find("different bodies"), std::string::npos);
  Clip brief = made_motions()[1];
  brief.poses.resize(12);
  EXPECT_NE(refusal_of({brief}).find("too short"), std::string::npos);
  MotionGraphOptions options;
  options.threshold_m = -0.1;
  EXPECT_NE(refusal_of(made_motions(), options).find("threshold"), std::string::npos);
}

TEST(MotionGraph, ARefusalTellsTheThresholdThatWouldDo) {
  MotionGraphOptions options;
  options.threshold_m = 1e-4;
  const std::vector<Clip> start = {made_motions()[1]};
  const std::string refusal = refusal_of(start, options);
  const std::size_t at = refusal.find("raise the threshold to ");
  ASSERT_NE(at, std::string::npos) << refusal;
  options.threshold_m = std::stod(refusal.substr(at + 23));
  EXPECT_EQ(refusal_of(start, options), "");
}

TEST(MotionGraph, AllMotionsCanBeModifiedAlike) {
  Modification droop;
  droop.posture = {{PostureUnit::head_flexion, 25.0}};
  std::vector<Clip> clips;
  for (const Clip& clip : made_graph().clips) clips.push_back(modified(clip, droop));
  const MotionGraph graph = with_motions(made_graph(), clips);
  ASSERT_EQ(graph.transitions.size(), made_graph().transitions.size());
  for (const GraphTransition& t : graph.transitions) EXPECT_LT(t.metres, 1.5 * graph.threshold_m);
  const Clip bowed = motion_of(graph, random_walk(graph, 5.0, 1));
  const Clip upright = motion_of(made_graph(), random_walk(made_graph(), 5.0, 1));
  ASSERT_EQ(bowed.frame_count(), upright.frame_count());
  const auto face = [](const Clip& clip) {
    const JointTransforms world = world_transforms(clip.body, clip.poses[60]);
    return (world.rotations[Head] * Vec3::UnitZ()).y();
  };
  EXPECT_LT(face(bowed), face(upright) - 0.2);
  clips.pop_back();
  EXPECT_THROW(with_motions(made_graph(), clips), Error);
  clips.push_back(made_motions()[0]);
  clips.back().poses.pop_back();
  EXPECT_THROW(with_motions(made_graph(), clips), Error);
}

TEST(MotionGraph, AVersionInStepBringsItsTempo) {
  const Example normal = walk(WalkStyle{}, 30.0, standard_body());
  const Example slow = walk(slow_walk(), 30.0, standard_body());
  const MotionGraph graph = motion_graph(std::vector<Clip>{normal.clip});
  const Clip& reference = graph.clips.front();
  const auto keytimes = [](const Example& example, int cycles) {
    std::vector<double> times;
    for (int cycle = 0; cycle < cycles; ++cycle) {
      for (std::size_t k = 0; k + 1 < example.keytimes.size(); ++k) {
        times.push_back(cycle * example.clip.duration_seconds() + example.keytimes[k]);
      }
    }
    return times;
  };
  const int cycles = reference.frame_count() / normal.clip.frame_count();
  const SynchronisedMotion version = synchronised(
      repeated(slow.clip, cycles + 1), keytimes(slow, cycles), reference, keytimes(normal, cycles));
  const MotionGraph slowed = with_motions(graph, std::vector<SynchronisedMotion>{version});
  const GraphWalk way = random_walk(graph, 10.0, 3);
  const double ratio =
      motion_of(slowed, way).duration_seconds() / motion_of(graph, way).duration_seconds();
  EXPECT_NEAR(ratio, slow.clip.duration_seconds() / normal.clip.duration_seconds(), 0.15);
  EXPECT_THROW(
      synchronised(slow.clip, std::vector<double>{0.0}, reference, std::vector<double>{0.0}),
      Error);
}

}  // namespace
}  // namespace mien::motion
