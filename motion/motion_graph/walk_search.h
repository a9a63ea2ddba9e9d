#pragma once

#include <functional>
#include <span>
#include <vector>

#include "motion/motion_graph/graph_walk.h"
#include "motion/motion_graph/guided_walk.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// How an edge leads over the floor, in the frame of the clip that it leaves.
struct EdgeSteps {
  std::vector<Vec3> steps;      ///< of the pelvis, metres, a frame
  std::vector<double> facings;  ///< of the pelvis after each step, radians about +Y from +Z
  std::vector<double> seconds;  ///< that each step lasts
  double turn = 0.0;            ///< of the clip that it leads to on the one that it leaves, radians
};

/// Of every edge of the graph, as `motion_of` (graph_walk.h) plays it, feet unlocked.
std::vector<EdgeSteps> edge_steps(const MotionGraph& graph);

/// Where a walk has come to.
struct WalkState {
  int node = 0;
  double turn = 0.0;          ///< of the node's clip, radians
  Vec3 place = Vec3::Zero();  ///< of the pelvis on the floor
  double facing = 0.0;        ///< radians
  double seconds = 0.0;       ///< since the walk began
  double played = 0.0;        ///< seconds of the first version's own time
  double since = 0.0;         ///< since the last transition, of the same time
  double way = 0.0;           ///< along what is followed; kept by the cost
};

/// What one more frame costs, ≥ 0: the state is after it but for `way`, which the cost may move on.
using FrameCost = std::function<double(WalkState& state, const Vec3& step)>;
/// Whether the purpose is reached.
using WalkDone = std::function<bool(const WalkState& state)>;

/// Versions of one graph (motion_graph.h) and what is asked of them by time, which the search mixes
/// as `motion_of` (graph_walk.h) does, but without delay.
struct MixedGraph {
  std::span<const MotionGraph> versions;
  std::span<const MoodFrom> moods;

  const MotionGraph& graph() const { return versions.front(); }
};

/// The cheapest walk from each of some starts (of one cost), stretch by stretch by branch and
/// bound, until it is done. Throws mien::Error when `way` does not get on (`gets_on`).
GraphWalk searched_walk(const MixedGraph& mixed, const std::vector<WalkState>& starts,
                        const FrameCost& cost, const WalkDone& done,
                        const GuidedWalkOptions& options);

}  // namespace mien::motion
