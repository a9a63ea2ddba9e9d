#include "motion/motion_graph/walk_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/error.h"
#include "motion/motion_graph/walk_frames.h"

namespace mien::motion {

namespace {

/// The state of a search for one stretch.
struct StretchSearch {
  const MixedGraph& mixed;
  const std::vector<std::vector<EdgeSteps>>& steps;  ///< of each version
  const FrameCost& cost;
  const GoalReached& done;
  const GuidedWalkOptions& options;
  double until = 0.0;  ///< of WalkState::played
  int tried = 0;
  std::vector<int> edges;
  std::vector<int> best_edges;
  double best = std::numeric_limits<double>::infinity();
};

/// The successor state of an edge, with its cost.
struct Branch {
  int edge = 0;
  WalkState state;
  double cost = 0.0;
  bool done = false;
};

/// One frame of an edge.
struct FrameStep {
  Vec3 step = Vec3::Zero();
  double facing = 0.0;
  double seconds = 0.0;
};

FrameStep mixed_step(const StretchSearch& search, std::size_t edge, std::size_t f, double now) {
  const EdgeSteps& first = search.steps.front()[edge];
  if (search.steps.size() == 1) return {first.steps[f], first.facings[f], first.seconds[f]};
  const std::vector<double> shares =
      requested_shares(search.mixed.moods, now, search.mixed.versions.size());
  FrameStep mix;
  mix.facing = first.facings[f];
  for (std::size_t v = 0; v < shares.size(); ++v) {
    const EdgeSteps& way = search.steps[v][edge];
    mix.step += shares[v] * way.steps[f];
    mix.facing += shares[v] * std::remainder(way.facings[f] - first.facings[f], 2.0 * pi);
    mix.seconds += shares[v] * way.seconds[f];
  }
  return mix;
}

Branch along(const StretchSearch& search, const WalkState& from, int edge) {
  const auto number = static_cast<std::size_t>(edge);
  const EdgeSteps& way = search.steps.front()[number];
  const Quat turned(Eigen::AngleAxisd(from.turn, Vec3::UnitY()));
  Branch branch{edge, from};
  for (std::size_t f = 0; f < way.steps.size() && !branch.done; ++f) {
    const FrameStep mix = mixed_step(search, number, f, branch.state.seconds);
    const Vec3 step = turned * mix.step;
    branch.state.place += step;
    branch.state.facing = from.turn + mix.facing;
    branch.state.seconds += mix.seconds;
    branch.state.played += way.seconds[f];
    branch.cost += search.cost(branch.state, step);
    branch.done = search.done(branch.state);
  }
  const GraphEdge& taken = search.mixed.graph().edges[number];
  branch.state.node = taken.to;
  branch.state.turn += way.turn;
  branch.state.since = taken.transition >= 0 ? 0.0 : from.since + branch.state.played - from.played;
  return branch;
}

std::vector<Branch> branches(StretchSearch& search, const WalkState& from) {
  const std::vector<int>& leaving =
      search.mixed.graph().leaving[static_cast<std::size_t>(from.node)];
  const auto first = static_cast<std::size_t>(leaving.front());
  const bool goes_on = search.mixed.graph().edges[first].transition < 0;
  std::vector<Branch> found;
  for (const int edge : leaving) {
    const bool transition =
        search.mixed.graph().edges[static_cast<std::size_t>(edge)].transition >= 0;
    if (transition && goes_on && from.since < search.options.between_seconds - 1e-9) continue;
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
    if (branch.done || branch.state.played >= search.until) {
      search.best = total;
      search.best_edges = search.edges;
    } else if (search.tried < search.options.most_edges || search.best_edges.empty()) {
      extend(search, branch.state, total);
    }
    search.edges.pop_back();
  }
}

StretchSearch stretch_from(const MixedGraph& mixed,
                           const std::vector<std::vector<EdgeSteps>>& steps, const WalkState& start,
                           const FrameCost& cost, const GoalReached& done,
                           const GuidedWalkOptions& options) {
  StretchSearch search{mixed, steps, cost, done, options};
  search.until = start.played + options.ahead_seconds;
  extend(search, start, 0.0);
  return search;
}

/// The start whose first stretch costs least.
WalkState best_start(const MixedGraph& mixed, const std::vector<std::vector<EdgeSteps>>& steps,
                     const std::vector<WalkState>& starts, const FrameCost& cost,
                     const GoalReached& done, GuidedWalkOptions options) {
  options.most_edges /= 20;
  double least = std::numeric_limits<double>::infinity();
  WalkState best = starts.front();
  for (const WalkState& start : starts) {
    const double found = stretch_from(mixed, steps, start, cost, done, options).best;
    if (found >= least) continue;
    least = found;
    best = start;
  }
  return best;
}

}  // namespace

std::vector<EdgeSteps> edge_steps(const MotionGraph& graph) {
  std::vector<EdgeSteps> all;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const GraphEdge& edge = graph.edges[e];
    EdgeSteps way;
    for (const WalkFrame& frame : frames_of(graph, {{static_cast<int>(e)}})) {
      const Pose pose = posture_of(graph, frame, 0.0);
      const Vec3 forward = pose.rotations.front() * Vec3::UnitZ();
      way.steps.push_back(step_of(graph, frame, 0.0));
      way.facings.push_back(std::atan2(forward.x(), forward.z()));
      way.seconds.push_back(seconds_of(graph, frame));
    }
    if (edge.transition >= 0) {
      way.turn = graph.transitions[static_cast<std::size_t>(edge.transition)].turn;
    }
    all.push_back(std::move(way));
  }
  return all;
}

GraphWalk search_walk(const MixedGraph& mixed, const std::vector<WalkState>& starts,
                      const FrameCost& cost, const GoalReached& done,
                      const GuidedWalkOptions& options) {
  constexpr double longest_seconds = 3600.0;
  std::vector<std::vector<EdgeSteps>> steps;
  for (const MotionGraph& version : mixed.versions) steps.push_back(edge_steps(version));
  WalkState state = best_start(mixed, steps, starts, cost, done, options);
  GraphWalk walk;
  while (!done(state)) {
    const StretchSearch search = stretch_from(mixed, steps, state, cost, done, options);
    const double way = state.way;
    const double kept = state.played + options.kept_seconds;
    for (const int edge : search.best_edges) {
      const Branch taken = along(search, state, edge);
      walk.edges.push_back(edge);
      state = taken.state;
      if (taken.done) return walk;
      if (state.played >= kept) break;
    }
    if (state.way < way + 0.02 || state.seconds > longest_seconds) {
      throw Error("the motion graph cannot follow the path any further",
                  "add motions that walk and turn in this way, or raise its threshold");
    }
  }
  return walk;
}

}  // namespace mien::motion
