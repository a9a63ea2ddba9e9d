#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "motion/math/random_number.h"
#include "motion/motion_graph/graph_walk.h"

namespace mien::motion::test {

/// A walk of at least so many seconds that chooses at the nodes at random, of the seed alone, and
/// lets half a second pass between transitions where the clips go on for so long.
inline GraphWalk random_walk(const MotionGraph& graph, double seconds, std::uint64_t seed) {
  constexpr double least_between = 0.5;  // seconds from transition to transition
  GraphWalk walk;
  const double step = 1.0 / graph.clips.front().frames_per_second;
  double walked = 0.0;
  std::uint64_t draw = 0;
  const auto choose = [&](std::size_t count) {
    const double share = 0.5 + 0.5 * random_number(seed, "walk over a motion graph", draw++);
    return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
  };
  auto node = choose(graph.nodes.size());
  double since = 0.0;  // the last transition, seconds
  while (walked < seconds) {
    const std::vector<int>& leaving = graph.leaving[node];
    const bool goes_on = graph.edges[static_cast<std::size_t>(leaving.front())].transition < 0;
    const bool early = since < least_between && goes_on;
    const int edge = leaving[early ? 0 : choose(leaving.size())];
    walk.edges.push_back(edge);
    const GraphEdge& taken = graph.edges[static_cast<std::size_t>(edge)];
    walked += step * taken.frames;
    since = taken.transition >= 0 ? 0.0 : since + step * taken.frames;
    node = static_cast<std::size_t>(graph.edges[static_cast<std::size_t>(edge)].to);
  }
  return walk;
}

}  // namespace mien::motion::test
