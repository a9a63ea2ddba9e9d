#pragma once

#include <functional>
#include <span>
#include <vector>

#include "motion/motion_graph/graph_walk.h"
#include "motion/motion_graph/guided_walk.h"
#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// Horizontal motion of an edge, in the coordinates of the clip that it leaves.
struct EdgeSteps {
  std::vector<Vec3> steps;      ///< displacement of the pelvis in each frame, metres
  std::vector<double> facings;  ///< of the pelvis in each frame, radians about +Y from +Z
  std::vector<double> seconds;  ///< duration of each frame
  /// Rotation that aligns the clip that the edge enters with the one that it leaves, radians.
  double turn = 0.0;
};

/// The steps of every edge of the graph, as in `motion_of` (graph_walk.h) without foot lock.
std::vector<EdgeSteps> edge_steps(const MotionGraph& graph);

/// State of a walk during the search.
struct WalkState {
  int node = 0;
  double turn = 0.0;          ///< rotation of the node's clip, radians
  Vec3 place = Vec3::Zero();  ///< of the pelvis on the floor
  double facing = 0.0;        ///< radians
  double seconds = 0.0;       ///< since the start of the walk
  double played = 0.0;        ///< seconds since the start, if only the first version were played
  double since = 0.0;         ///< seconds since the last transition, measured like `played`
  /// Progress towards the goal. The cost function advances it and chooses its unit: metres along a
  /// path, or seconds.
  double way = 0.0;
};

/// Cost of one more frame, ≥ 0. `step` is the displacement in this frame. `place`, `facing`,
/// `seconds` and `played` of `state` are those after the frame; the cost may advance `way`.
using FrameCost = std::function<double(WalkState& state, const Vec3& step)>;
/// Whether the walk has reached its goal.
using GoalReached = std::function<bool(const WalkState& state)>;

/// Versions of one graph (motion_graph.h) and the changes of their weights. The search blends the
/// versions as `motion_of` (graph_walk.h) does, but follows a change of weights at once.
struct MixedGraph {
  std::span<const MotionGraph> versions;
  std::span<const MoodChange> moods;

  const MotionGraph& graph() const { return versions.front(); }
};

/// A walk from the best of several starts until `done`. Branch and bound finds the cheapest walk
/// over the next `ahead_seconds`, of which about `kept_seconds` are kept before the next search.
/// Throws mien::Error when `way` makes no progress, and when the walk takes over an hour.
GraphWalk search_walk(const MixedGraph& mixed, const std::vector<WalkState>& starts,
                      const FrameCost& cost, const GoalReached& done,
                      const GuidedWalkOptions& options);

}  // namespace mien::motion
