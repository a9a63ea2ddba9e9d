#pragma once

#include <cstdint>
#include <vector>

#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// A way over the edges of a graph: edge after edge, each from where the one before leads.
struct GraphWalk {
  std::vector<int> edges;
};

/// One frame of a walk: of one clip, or between two during a transition.
struct WalkFrame {
  int clip = 0;
  int frame = 0;
  int to_clip = -1;  ///< the clip that is entered; −1 outside of transitions
  int to_frame = 0;
  double share = 1.0;  ///< of the first clip: 2p³ − 3p² + 1 over the window (Kovar 2002, eq. 6)
  double turn = 0.0;   ///< of the second clip onto the first, radians
};

std::vector<WalkFrame> frames_of(const MotionGraph& graph, const GraphWalk& walk);

/// Joints, heading and height of a frame of a walk, the first clip turned by `turn` (radians); over
/// the floor at x = z = 0. And the step over the floor that leads to it.
Pose posture_of(const MotionGraph& graph, const WalkFrame& frame, double turn);
Vec3 step_of(const MotionGraph& graph, const WalkFrame& frame, double turn);

struct GraphWalkOptions {
  Vec3 place = Vec3::Zero();  ///< where the first frame's pelvis stands, on the floor
  double heading = 0.0;       ///< radians about +Y from +Z: where the first frame's pelvis faces
  /// Feet that stand on both sides of a transition stand through it, and the others come down
  /// where they stay: feet are locked (gait/foot_lock.h) in plants that touch a transition.
  bool lock_feet = true;
};

/// The motion of a walk, which does not loop. Over the floor the root goes on, frame by frame, by
/// the steps and turns of its clips, in transitions by their weighted mean, so its path has no jump
/// but those of the clips; joints and height are interpolated. Frames last as long as the graph
/// says (`frame_seconds`), and are sampled at its frame rate. Throws mien::Error for a walk without
/// frames, and for edges that do not follow one another.
Clip motion_of(const MotionGraph& graph, const GraphWalk& walk,
               const GraphWalkOptions& options = {});

/// Where the foot stands in each frame of a walk, as stretches. In a transition the foot stands as
/// in the clip that weighs more.
std::vector<FootPlant> plants_of(const MotionGraph& graph, const std::vector<WalkFrame>& frames);

/// A walk of at least so many seconds that chooses at the nodes at random, of the seed alone, and
/// lets half a second pass between transitions where the clips go on for so long.
/// Throws mien::Error for a duration that is not positive or more than an hour.
GraphWalk random_walk(const MotionGraph& graph, double seconds, std::uint64_t seed);

}  // namespace mien::motion
