#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/motion_graph/graph_walk.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

struct GuidedWalkOptions {
  /// Look-ahead of the search, and how much of its result is kept before the next search, seconds
  /// (Kovar, Gleicher and Pighin 2002, section 5.2: 80–120 and 25–30 frames).
  double ahead_seconds = 2.5;
  double kept_seconds = 0.8;
  /// Least time between transitions, seconds, if the clip is long enough.
  double between_seconds = 0.4;
  /// Largest number of edges tried in each search; the best walk found so far is then used.
  int most_edges = 60000;
};

/// A turn of a script that the graph's motions miss.
struct MissedTurn {
  std::size_t segment = 0;  ///< of the script
  double degrees = 0.0;     ///< missing at the end, to the left
};

/// A walk found by search, and its motion.
struct GuidedWalk {
  GraphWalk walk;
  Clip clip;
  std::vector<FootPlant> plants;     ///< where its feet stand
  std::optional<MissedTurn> missed;  ///< the worst turn, of a script, by more than some degrees
};

/// A walk along a path over the floor (a polyline; x, z in metres), found by branch and bound in
/// stretches (Kovar, Gleicher and Pighin 2002, section 5): of all walks that look so far ahead the
/// one with the least sum of squared distances from the path, of squared angles to it and of lost
/// progress. How far is looked ahead goes by the time of the graph's own motions, whatever versions
/// make of it. It begins on the first point, facing along, and ends when the path does.
/// Deterministic.
///
/// Throws mien::Error for a path that is none (floor_path.h), for options out of range, and when
/// the graph's motions do not get on (less than 2 cm of the path in a stretch) or stray by more
/// than a metre, as straight walks do on a path that turns.
GuidedWalk walk_along(const MotionGraph& graph, std::span<const Vec3> path,
                      const GuidedWalkOptions& options = {});

/// As above over several versions of one graph, mixed by moods on the way (graph_walk.h).
GuidedWalk walk_along(std::span<const MotionGraph> versions, std::span<const Vec3> path,
                      std::span<const MoodChange> moods, const GuidedWalkOptions& options = {});

/// A walk that follows a script (scripted_walk.h), found by the same search: at each moment it is
/// to have the speed and heading of the script, where `pace` 1 is the fastest tenth of the graph's
/// frames and turns are made at 60°/s, on the spot at 45°/s. What the heading is off by at the end
/// of a turn, a walk or a stand is spread over the way there, up to 25° and 12°/s: the body is
/// turned and its feet are locked. Turns that still deviate by more than 5° are reported
/// (`missed`). Moods are ignored. Throws as above, and for an empty script.
GuidedWalk scripted_walk(const MotionGraph& graph, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options = {});

/// As above over several versions of one graph: `moods` of the script are their weights, from a
/// segment's beginning on; before the first the first version walks alone.
GuidedWalk scripted_walk(std::span<const MotionGraph> versions, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options = {});

}  // namespace mien::motion
