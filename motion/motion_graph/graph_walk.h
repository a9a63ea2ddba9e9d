#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/motion_graph.h"
#include "motion/motion_graph/walk_frames.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

struct GraphWalkOptions {
  Vec3 place = Vec3::Zero();  ///< floor position of the pelvis in the first frame, metres
  double heading = 0.0;       ///< of the pelvis in the first frame, radians about +Y from +Z
  /// Whether to lock feet (gait/foot_lock.h) in plants that overlap a transition (in all plants, if
  /// several versions of a graph are blended), so that planted feet do not slide.
  bool lock_feet = true;
  /// Additional heading of each frame, radians to the left; it bends the path too. Empty: none. If
  /// given, `lock_feet` applies to all plants, so that feet stand still while the body turns above
  /// them.
  std::vector<double> added_headings;
};

/// The motion of a walk; it does not loop. The horizontal root motion accumulates the displacements
/// and rotations of the clips from frame to frame (their weighted mean in transitions), so that
/// transitions add no jumps; joint rotations and height are interpolated. Frames last as long as
/// the graph's `frame_seconds` states; the result is sampled at the graph's frame rate. Throws
/// mien::Error for a walk without frames, for edges that are not consecutive, and if there are
/// added headings but not one per frame.
Clip motion_of(const MotionGraph& graph, const GraphWalk& walk,
               const GraphWalkOptions& options = {});

/// The motion of a walk over several versions of one graph (`with_motions`), such as moods, which
/// are blended along the walk. Each of `moods` holds the weights of the versions (≥ 0; only ratios
/// matter) from its time on; the first applies before its time, too. The blend follows a change
/// smoothly (half of it within 0.14 s). If `moods` is empty, the first version is used. Tempo is
/// blended too. Throws as above, for versions of different graphs, and for invalid weights.
Clip motion_of(std::span<const MotionGraph> versions, const GraphWalk& walk,
               std::span<const MoodChange> moods, const GraphWalkOptions& options = {});

/// Like the above, with the foot plants.
WalkedClip walked_clip(std::span<const MotionGraph> versions, const GraphWalk& walk,
                       std::span<const MoodChange> moods, const GraphWalkOptions& options = {});

/// Start time of each frame of a walk, seconds, and the pelvis' facing direction in that frame,
/// radians about +Y from +Z.
struct WalkHeadings {
  std::vector<double> seconds;
  std::vector<double> facings;
};

WalkHeadings headings_of(std::span<const MotionGraph> versions, const GraphWalk& walk,
                         std::span<const MoodChange> moods, const GraphWalkOptions& options = {});

}  // namespace mien::motion
