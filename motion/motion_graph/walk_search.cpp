#include "motion/motion_graph/walk_search.h"

#include <algorithm>
#include <limits>

#include "motion/error.h"

namespace mien::motion {

namespace {

/// The state of a search for one stretch.
struct StretchSearch {
  const MotionGraph& graph;
  const std::vector<EdgeSteps>& steps;
  const FrameCost& cost;
  const WalkDone& done;
  const GuidedWalkOptions& options;
  double until = 0.0;  ///< seconds
  int tried = 0;
  std::vector<int> edges;
  std::vector<int> best_edges;
  double best = std::numeric_limits<double>::infinity();
};

/// What an edge leads to, and at what cost.
struct Branch {
  int edge = 0;
  WalkState state;
  double cost = 0.0;
  bool done = false;
};

Branch along(const StretchSearch& search, const WalkState& from, int edge) {
  const EdgeSteps& way = search.steps[static_cast<std::size_t>(edge)];
  const double frame = 1.0 / search.graph.clips.front().frames_per_second;
  const Quat turned(Eigen::AngleAxisd(from.turn, Vec3::UnitY()));
  Branch branch{edge, from};
  for (std::size_t f = 0; f < way.steps.size() && !branch.done; ++f) {
    const Vec3 step = turned * way.steps[f];
    branch.state.place += step;
    branch.state.facing = from.turn + way.facings[f];
    branch.state.seconds += frame;
    branch.cost += search.cost(branch.state, step);
    branch.done = search.done(branch.state);
  }
  const GraphEdge& taken = search.graph.edges[static_cast<std::size_t>(edge)];
  branch.state.node = taken.to;
  branch.state.turn += way.turn;
  branch.state.since =
      taken.transition >= 0 ? 0.0 : from.since + frame * static_cast<double>(way.steps.size());
  return branch;
}

std::vector<Branch> branches(StretchSearch& search, const WalkState& from) {
  const std::vector<int>& leaving = search.graph.leaving[static_cast<std::size_t>(from.node)];
  const auto first = static_cast<std::size_t>(leaving.front());
  const bool goes_on = search.graph.edges[first].transition < 0;
  std::vector<Branch> found;
  for (const int edge : leaving) {
    const bool transition = search.graph.edges[static_cast<std::size_t>(edge)].transition >= 0;
    if (transition && goes_on && from.since < search.options.between_seconds) continue;
    found.push_back(along(search, from, edge));
    ++search.tried;
  }
  // The cheapest a second first: what is found early bounds the rest.
  const auto rate = [&](const Branch& branch) {
    return branch.cost / (branch.state.seconds - from.seconds);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Branch& x, const Branch& y) { return rate(x) < rate(y); });
  return found;
}

void extend(StretchSearch& search, const WalkState& from, double spent) {
  for (const Branch& branch : branches(search, from)) {
    const double total = spent + branch.cost;
    if (total >= search.best) continue;
    search.edges.push_back(branch.edge);
    if (branch.done || branch.state.seconds >= search.until) {
      search.best = total;
      search.best_edges = search.edges;
    } else if (search.tried < search.options.most_edges || search.best_edges.empty()) {
      extend(search, branch.state, total);
    }
    search.edges.pop_back();
  }
}

StretchSearch stretch_from(const MotionGraph& graph, const std::vector<EdgeSteps>& steps,
                           const WalkState& start, const FrameCost& cost, const WalkDone& done,
                           const GuidedWalkOptions& options) {
  StretchSearch search{graph, steps, cost, done, options};
  search.until = start.seconds + options.ahead_seconds;
  extend(search, start, 0.0);
  return search;
}

/// The start whose first stretch costs least.
WalkState best_start(const MotionGraph& graph, const std::vector<EdgeSteps>& steps,
                     const std::vector<WalkState>& starts, const FrameCost& cost,
                     const WalkDone& done, GuidedWalkOptions options) {
  options.most_edges /= 20;
  double least = std::numeric_limits<double>::infinity();
  WalkState best = starts.front();
  for (const WalkState& start : starts) {
    const double found = stretch_from(graph, steps, start, cost, done, options).best;
    if (found >= least) continue;
    least = found;
    best = start;
  }
  return best;
}

}  // namespace

GraphWalk searched_walk(const MotionGraph& graph, const std::vector<WalkState>& starts,
                        const FrameCost& cost, const WalkDone& done,
                        const GuidedWalkOptions& options) {
  constexpr double longest_seconds = 3600.0;
  const std::vector<EdgeSteps> steps = edge_steps(graph);
  WalkState state = best_start(graph, steps, starts, cost, done, options);
  GraphWalk walk;
  while (!done(state)) {
    const StretchSearch search = stretch_from(graph, steps, state, cost, done, options);
    const double way = state.way;
    const double kept = state.seconds + options.kept_seconds;
    for (const int edge : search.best_edges) {
      const Branch taken = along(search, state, edge);
      walk.edges.push_back(edge);
      state = taken.state;
      if (taken.done) return walk;
      if (state.seconds >= kept) break;
    }
    if (state.way < way + 0.02 || state.seconds > longest_seconds) {
      throw Error("the motion graph does not get on along what it is to follow",
                  "add motions that walk and turn so, or raise its threshold");
    }
  }
  return walk;
}

}  // namespace mien::motion
