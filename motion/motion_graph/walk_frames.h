#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/motion_graph.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

/// Requested shares of a graph's versions at a time, sum 1: those of the last change until then, or
/// of the first; the first version alone if there is no change.
std::vector<double> requested_shares(std::span<const MoodChange> moods, double seconds,
                                     std::size_t versions);

/// A walk in a graph: consecutive edges.
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

/// `share` in a frame of a transition's window.
double blend_share(int frame, int window);

std::vector<WalkFrame> frames_of(const MotionGraph& graph, const GraphWalk& walk);

/// Joints, heading and height of a frame of a walk, the first clip turned by `turn` (radians); over
/// the floor at x = z = 0. And the step over the floor that leads to it.
Pose posture_of(const MotionGraph& graph, const WalkFrame& frame, double turn);
Vec3 step_of(const MotionGraph& graph, const WalkFrame& frame, double turn);

/// Duration of the frame, seconds.
double seconds_of(const MotionGraph& graph, const WalkFrame& frame);

/// Foot plants of a walk. In a transition contact is that of the clip with the larger weight.
std::vector<FootPlant> plants_of(const MotionGraph& graph, const std::vector<WalkFrame>& frames);

}  // namespace mien::motion
