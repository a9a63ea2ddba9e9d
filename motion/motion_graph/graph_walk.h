#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/motion_graph.h"
#include "motion/motion_graph/walk_frames.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

struct GraphWalkOptions {
  Vec3 place = Vec3::Zero();  ///< where the first frame's pelvis stands, on the floor
  double heading = 0.0;       ///< radians about +Y from +Z: where the first frame's pelvis faces
  /// Feet that stand on both sides of a transition stand through it, and the others land where they
  /// stay: feet are locked (gait/foot_lock.h) in plants that touch a transition.
  bool lock_feet = true;
  /// Additional heading of each frame, radians to the left, which turns the path too; empty: none.
  /// With it all planted feet are locked: they stand while the body turns over them.
  std::vector<double> added_headings;
};

/// The motion of a walk, which does not loop. Over the floor the root goes on, frame by frame, by
/// the steps and turns of its clips, in transitions by their weighted mean, so its path has no jump
/// but those of the clips; joints and height are interpolated. Frames last as long as the graph
/// says (`frame_seconds`), and are sampled at its frame rate. Throws mien::Error for a walk without
/// frames, and for edges that do not follow one another.
Clip motion_of(const MotionGraph& graph, const GraphWalk& walk,
               const GraphWalkOptions& options = {});

/// The motion of a walk over several versions of one graph (`with_motions`: moods, say), which are
/// mixed as it goes on: `moods` are the versions' weights from a moment on, ≥ 0, divided by their
/// sum, and followed within some 0.2 s; without any it is the first version. Tempo is mixed too.
/// Throws as above, for versions of other graphs, and for weights that are none.
Clip motion_of(std::span<const MotionGraph> versions, const GraphWalk& walk,
               std::span<const MoodChange> moods, const GraphWalkOptions& options = {});

/// As above, with the foot plants.
WalkedClip walked_clip(std::span<const MotionGraph> versions, const GraphWalk& walk,
                       std::span<const MoodChange> moods, const GraphWalkOptions& options = {});

/// Start time of each frame of a walk, seconds, and the pelvis' facing direction in it, radians.
struct WalkHeadings {
  std::vector<double> seconds;
  std::vector<double> facings;
};

WalkHeadings headings_of(std::span<const MotionGraph> versions, const GraphWalk& walk,
                         std::span<const MoodChange> moods, const GraphWalkOptions& options = {});

}  // namespace mien::motion
