#pragma once

#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/motion_graph/point_cloud.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct MotionGraphOptions {
  /// Largest distance of windows that are joined, metres (point_cloud.h: root mean square over
  /// joints and virtual points, after alignment). The default of 0.06 m is our choice: the
  /// adjective paper's threshold for "the same motion". In captures, windows of one walking actor
  /// join from about 0.04 m, and blends of dissimilar motions become visible above 0.1 m. Kovar et
  /// al. set the threshold by hand for every kind of motion.
  double threshold_m = 0.06;
  /// Options for comparing windows; the window's length is also the duration of transitions.
  CloudOptions cloud;
  /// Largest share of the window's frames in which a foot may be planted in one motion but not in
  /// the other. Blending a planted foot with a swinging one makes it slide, which foot locking
  /// cannot repair.
  double most_contact_change = 0.25;
  /// Largest mean difference, over the window, between the facing directions of the pelvis in the
  /// two motions, degrees; if it is larger after the alignment, the second motion is rotated until
  /// it is not. The blend rotates the pelvis by the remaining difference, in addition to the
  /// motions' own rotation: 5° over a third of a second add up to 0.7° per frame at 30 frames per
  /// second. Where the blend would rotate the pelvis faster than both motions by 0.9° per frame or
  /// more, a smaller limit applies: 3/4, 1/2 or 1/4 of this value, or 0.
  double most_facing_change_deg = 5.0;
  /// Threads for the comparison; 0: one per processor. The graph does not depend on their number.
  int threads = 0;
  /// Looping clips are repeated for this duration, seconds, or for one cycle if that is longer, and
  /// continue for one window more, so that the end can join the start.
  double unrolled_seconds = 2.0;
};

/// A transition between two similar windows: from frame `from_frame` on, one clip is blended into
/// the other over the window.
struct GraphTransition {
  int from_clip = 0;
  int from_frame = 0;  ///< first frame of the blend in `from_clip`
  int to_clip = 0;
  int to_frame = 0;     ///< first frame of the blend in `to_clip`
  double metres = 0.0;  ///< distance of the windows
  /// Rotation about +Y that aligns the second clip with the first, radians: that of the least
  /// distance, changed where `most_facing_change_deg` requires it.
  double turn = 0.0;
};

/// A branching point in a clip, just before `frame`.
struct GraphNode {
  int clip = 0;
  int frame = 0;
};

/// Frames of a clip between two nodes, or a transition.
struct GraphEdge {
  int from = 0;         ///< index of the node where it begins
  int to = 0;           ///< index of the node where it ends
  int transition = -1;  ///< index into transitions; −1: the clip continues
  int frames = 0;       ///< number of frames
};

/// A motion graph (Kovar, Gleicher and Pighin, SIGGRAPH 2002): motions joined where they are
/// similar, so that any walk along its edges is a motion. Every node can be reached from every
/// other.
struct MotionGraph {
  std::vector<Clip> clips;                     ///< of one body at one frame rate; none loops
  std::vector<std::vector<FootPlant>> plants;  ///< of each clip
  int window = 10;                             ///< frames of a transition
  double threshold_m = 0.0;
  CloudOptions cloud;
  double most_facing_change_deg = 5.0;
  std::vector<GraphTransition> transitions;
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
  std::vector<std::vector<int>> leaving;  ///< edges from each node, the clip's continuation first
  /// Duration of each frame of each clip, seconds, for motions that were synchronised with others
  /// and so differ in tempo (`synchronised`). Empty if every frame lasts 1 / frame rate.
  std::vector<std::vector<double>> frame_seconds;
};

/// The graph of the clips: local minima of the distance up to the threshold become transitions in
/// both directions, unless contacts differ too much (`most_contact_change`) or the entered clip
/// ends with the window; only the largest strongly connected component (by the number of frames on
/// its edges) is kept.
///
/// Throws mien::Error without clips, for clips shorter than two windows, for clips that are not of
/// the canonical body or differ in frame rate or body (in an offset by more than a millimetre), for
/// options out of range, and when no component contains a cycle; the message then states a
/// sufficient threshold, if one up to 1 m suffices.
MotionGraph motion_graph(std::span<const Clip> clips, const MotionGraphOptions& options = {});

/// The graph with its clips replaced by other motions with the same numbers of frames; they may
/// have another body than the former ones, but must all have the same. The topology is kept; the
/// alignments of the windows and the foot plants are recomputed. Use it to apply a modification
/// (modify/modification.h) to all clips, or to replace them by corresponding versions or by blends
/// of such. Throws mien::Error for clips that differ from the graph's in number, frames or frame
/// rate, that loop, or that differ from each other in body.
MotionGraph with_motions(MotionGraph graph, std::span<const Clip> clips);

/// A motion with the duration of each frame, as returned by `synchronised`.
struct SynchronisedMotion {
  Clip clip;
  std::vector<double> frame_seconds;
};
MotionGraph with_motions(MotionGraph graph, std::span<const SynchronisedMotion> motions);

/// A version of a motion synchronised with a reference by corresponding keytimes (seconds,
/// ascending, the same number in both): frame i shows the moment that corresponds to frame i of the
/// reference, and has its own duration. Throws mien::Error when there are fewer than two keytimes,
/// when they are not ascending or lie outside the clips, and when their numbers differ.
SynchronisedMotion synchronised(const Clip& version, std::span<const double> version_keytimes,
                                const Clip& reference, std::span<const double> reference_keytimes);

}  // namespace mien::motion
