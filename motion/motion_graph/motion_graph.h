#pragma once

#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/motion_graph/point_cloud.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

struct MotionGraphOptions {
  /// Windows whose distance (point_cloud.h: root mean square over joints and virtual points, after
  /// alignment) is more than this are not joined, metres. Ours: 0.06 m is where the adjective paper
  /// puts "the same motion"; captures of one actor walking join from about 0.04 m, unlike motions
  /// blend visibly above 0.1 m. The paper sets it by hand for every kind of motion.
  double threshold_m = 0.06;
  /// Comparison of windows; its window is also the duration of transitions.
  CloudOptions cloud;
  /// Share of the window's frames in which a foot may stand in one motion and not in the other. A
  /// blend of a foot that stands with one that swings slides, which locking it cannot mend.
  double most_contact_change = 0.25;
  /// Degrees by which the pelvis may face elsewhere in one motion than in the other, on the average
  /// over the window: any excess is removed from the alignment. The blend turns the pelvis by that
  /// much beside what the motions do: 5° over a third of a second by about 1° a frame; where it
  /// would be more, less is allowed.
  double most_facing_change_deg = 5.0;
  /// Threads for the comparison; 0: one a processor. The graph does not depend on it.
  int threads = 0;
  /// Looping clips are unrolled to at least this duration, seconds, and always by one window more
  /// than their cycles, so that their end meets their start.
  double unrolled_seconds = 2.0;
};

/// A transition between two similar windows: from frame `from_frame` on, one clip is blended into
/// the other over the window.
struct GraphTransition {
  int from_clip = 0;
  int from_frame = 0;  ///< first frame of the blend in the clip that is left
  int to_clip = 0;
  int to_frame = 0;     ///< first frame of the blend in the clip that is entered
  double metres = 0.0;  ///< distance of the windows
  double turn = 0.0;    ///< radians about +Y that lay the second clip on the first: of the least
                        ///< distance, within `most_facing_change_deg`
};

/// A branching point in a clip, before `frame`.
struct GraphNode {
  int clip = 0;
  int frame = 0;
};

/// Frames of a clip between two nodes, or a transition.
struct GraphEdge {
  int from = 0;         ///< node
  int to = 0;           ///< node
  int transition = -1;  ///< index; −1: the clip goes on
  int frames = 0;       ///< duration
};

/// A motion graph (Kovar, Gleicher and Pighin, SIGGRAPH 2002): motions cut where they are alike, so
/// that any walk over its edges is a motion. Every node can be reached from every other.
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
  std::vector<std::vector<int>> leaving;  ///< edges from each node; the one that goes on is first
  /// How long each frame of each clip lasts, seconds, where that is not one by the frame rate: the
  /// tempo of motions that were put in step with others (`synchronised`). Empty otherwise.
  std::vector<std::vector<double>> frame_seconds;
};

/// The graph of the clips: local minima of the distance below the threshold become transitions both
/// ways, what does not belong to the largest strongly connected component (by the frames of its
/// edges) is left out.
///
/// Throws mien::Error without clips, for clips that are shorter than two windows, differ in bones
/// (by more than a millimetre) or frame rate, for options out of range, and when no component with
/// a cycle is left: the message then states the smallest sufficient threshold.
MotionGraph motion_graph(std::span<const Clip> clips, const MotionGraphOptions& options = {});

/// The graph with its clips replaced by other motions of the same frames, on the same or another
/// body: the topology stays, the alignments of the windows are computed anew. So all clips can get
/// one modification (modify/modification.h), or be blends of corresponding versions. Throws
/// mien::Error for clips that do not match in number, frames, frame rate or body.
MotionGraph with_motions(MotionGraph graph, std::span<const Clip> clips);

/// A motion with the duration of each frame, as returned by `synchronised`.
struct SynchronisedMotion {
  Clip clip;
  std::vector<double> frame_seconds;
};
MotionGraph with_motions(MotionGraph graph, std::span<const SynchronisedMotion> motions);

/// A version of a motion synchronised with a reference by corresponding keytimes (seconds,
/// ascending, equally many): frame by frame the same moment, with the duration of each frame.
/// Throws mien::Error when the keytimes do not correspond or lie outside the clips.
SynchronisedMotion synchronised(const Clip& version, std::span<const double> version_keytimes,
                                const Clip& reference, std::span<const double> reference_keytimes);

}  // namespace mien::motion
