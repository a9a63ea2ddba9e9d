#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/motion_graph/graph_walk.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

struct GuidedWalkOptions {
  /// Look-ahead of each search, seconds (Kovar, Gleicher and Pighin 2002, section 5.2: 80–120
  /// frames), and how much of the walk found is kept before the next search (there: 25–30 frames).
  double ahead_seconds = 2.5;
  double kept_seconds = 0.8;
  /// Least time between transitions, seconds; less only where a clip ends earlier.
  double between_seconds = 0.4;
  /// Number of edges tried after which a search ends with the best walk found so far.
  int most_edges = 60000;
};

/// A turn of a script that the graph's motions cannot complete.
struct MissedTurn {
  std::size_t segment = 0;  ///< index in the script of the turn or curve; 0 if there was none
  double degrees = 0.0;     ///< missing angle at the end, positive to the left
};

/// A walk found by search, and its motion.
struct GuidedWalk {
  GraphWalk walk;
  Clip clip;
  std::vector<FootPlant> plants;     ///< foot plants of the clip
  std::optional<MissedTurn> missed;  ///< the turn of a script with the largest error, if over 5°
  /// Of a script: the time of the clip at which each segment begins, seconds; otherwise empty.
  std::vector<double> segment_starts = {};
};

/// A walk along a path on the floor (a polyline; x, z in metres), found in stretches by branch and
/// bound (Kovar, Gleicher and Pighin 2002, section 5): each search finds, within the look-ahead,
/// the walk with the least sum of squared distances from the path, squared angles between the
/// facing direction and the path, and lost progress. The walk starts at the path's first point,
/// facing along the path, and ends near its last point. Deterministic.
///
/// Throws mien::Error for an invalid path (floor_path.h), for options out of range, and when the
/// graph's motions make no progress (less than 2 cm along the path in a stretch) or stray by more
/// than a metre, as straight walks do on a curved path.
GuidedWalk walk_along(const MotionGraph& graph, std::span<const Vec3> path,
                      const GuidedWalkOptions& options = {});

/// As above over several versions of one graph, blended by moods along the walk (graph_walk.h). The
/// look-ahead is measured in the time of the first version, regardless of the tempo of the others.
GuidedWalk walk_along(std::span<const MotionGraph> versions, std::span<const Vec3> path,
                      std::span<const MoodChange> moods, const GuidedWalkOptions& options = {});

/// A walk that follows a script (scripted_walk.h), found by the same search: its speed and heading
/// follow the script at every time. A segment's `pace` of 1 is the speed that a tenth of the
/// graph's frames exceed; turns are made at 60°/s, or 45°/s on the spot. Heading errors at the ends
/// of segments are then corrected gradually (heading_correction.h), each by at most 25° and 12°/s,
/// by rotating the body and locking the feet. The turn with the largest remaining error above 5° is
/// reported (`missed`). Moods are ignored. Throws mien::Error for a script that is empty, contains
/// invalid numbers or takes over an hour, and for options out of range.
GuidedWalk scripted_walk(const MotionGraph& graph, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options = {});

/// As above over several versions of one graph: the `moods` of a segment are their weights from its
/// start on; until a segment sets moods, the first version is used alone.
GuidedWalk scripted_walk(std::span<const MotionGraph> versions, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options = {});

}  // namespace mien::motion
