#include <algorithm>

#include "motion/error.h"
#include "motion/math/random_number.h"
#include "motion/motion_graph/graph_walk.h"

namespace mien::motion {

namespace {

constexpr double least_between = 0.5;  // seconds from transition to transition

}  // namespace

GraphWalk random_walk(const MotionGraph& graph, double seconds, std::uint64_t seed) {
  if (!(seconds > 0.0) || seconds > 3600.0) {
    throw Error("a random walk that does not last between 0 and 3600 seconds",
                "choose its seconds");
  }
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

}  // namespace mien::motion
