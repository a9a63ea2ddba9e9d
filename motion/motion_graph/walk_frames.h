#pragma once

#include <span>
#include <vector>

#include "motion/motion_graph/motion_graph.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion {

/// Requested shares, at the time `seconds`, of the versions of a graph; they sum to 1. They are
/// those of the latest change up to this time or, before the first change, of the first change.
/// Without changes, the first version has the share 1.
std::vector<double> requested_shares(std::span<const MoodChange> moods, double seconds,
                                     std::size_t versions);

/// A walk in a graph: indices of consecutive edges.
struct GraphWalk {
  std::vector<int> edges;
};

/// One frame of a walk: a frame of one clip or, during a transition, a blend of frames of two
/// clips.
struct WalkFrame {
  int clip = 0;
  int frame = 0;
  int to_clip = -1;  ///< the clip that is entered; −1 outside of transitions
  int to_frame = 0;
  double share = 1.0;  ///< of `clip`: 2p³ − 3p² + 1 (Kovar et al. 2002, section 3.3), where p rises
                       ///< over the window, from above 0 to below 1; 1 outside of transitions
  double turn = 0.0;  ///< rotation that aligns `to_clip` with `clip`, radians
};

/// WalkFrame::share at a frame of a transition's window.
double blend_share(int frame, int window);

std::vector<WalkFrame> frames_of(const MotionGraph& graph, const GraphWalk& walk);

/// The pose of a frame of a walk at x = z = 0, and the horizontal displacement from the previous
/// frame, metres; `turn` is the rotation of `frame.clip` about +Y, radians.
Pose posture_of(const MotionGraph& graph, const WalkFrame& frame, double turn);
Vec3 step_of(const MotionGraph& graph, const WalkFrame& frame, double turn);

/// Duration of the frame, seconds.
double seconds_of(const MotionGraph& graph, const WalkFrame& frame);

/// Foot plants of a walk. In a transition, contacts are those of the clip with the larger share.
/// Plants of fewer than three frames are omitted.
std::vector<FootPlant> plants_of(const MotionGraph& graph, const std::vector<WalkFrame>& frames);

}  // namespace mien::motion
