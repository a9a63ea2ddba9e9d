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
  /// What is compared; its window is also how long transitions last.
  CloudOptions cloud;
  /// Share of the window's frames in which a foot may stand in one motion and not in the other. A
  /// blend of a foot that stands with one that swings slides, which locking it cannot mend.
  double most_contact_change = 0.25;
  /// Degrees by which the pelvis may face elsewhere in one motion than in the other, on the average
  /// over the window: what is more is taken off the alignment. The blend turns the pelvis by that
  /// much beside what the motions do: 5° over a third of a second by about 1° a frame; where it
  /// would be more, less is allowed.
  double most_facing_change_deg = 5.0;
  /// Threads for the comparison; 0: one a processor. The graph does not depend on it.
  int threads = 0;
  /// Looping clips are unrolled to at least so many seconds, and always by one window more than
  /// their cycles, so that their end meets their start.
  double unrolled_seconds = 2.0;
};

/// Two windows that are alike: after frame `from_frame` of a clip (exclusive) the motion may go
/// over, during the window, to the other clip.
struct GraphTransition {
  int from_clip = 0;
  int from_frame = 0;  ///< first frame of the blend in the clip that is left
  int to_clip = 0;
  int to_frame = 0;     ///< first frame of the blend in the clip that is entered
  double metres = 0.0;  ///< distance of the windows
  double turn = 0.0;    ///< radians about +Y that lay the second clip on the first: of the least
                        ///< distance, within `most_facing_change_deg`
};

/// A place in a clip from which there is a choice: the next frame to be played would be `frame`.
struct GraphNode {
  int clip = 0;
  int frame = 0;
};

/// Frames of a clip between two nodes, or a transition.
struct GraphEdge {
  int from = 0;         ///< node
  int to = 0;           ///< node
  int transition = -1;  ///< index; −1: the clip goes on
  int frames = 0;       ///< that it lasts
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
  /// tempo of motions that were put in step with others (`in_step`). Empty otherwise.
  std::vector<std::vector<double>> frame_seconds;
};

/// The graph of the clips: local minima of the distance below the threshold become transitions both
/// ways, what does not belong to the largest strongly connected component (by the frames of its
/// edges) is left out.
///
/// Throws mien::Error without clips, for clips that are shorter than two windows, differ in bones
/// (by more than a millimetre) or frame rate, for options out of range, and when no component with
/// a cycle is left: it then tells the threshold from which one is.
MotionGraph motion_graph(std::span<const Clip> clips, const MotionGraphOptions& options = {});

/// The graph with other motions in place of its clips, which have the same body or another one and
/// the same frames: where it can go stays as it was, how the windows lie on each other is found
/// anew. So all nodes can be put through one modification (modify/modification.h), or be blended of
/// versions that correspond. Throws mien::Error for clips that do not match in number, frames,
/// frame rate or body.
MotionGraph with_motions(MotionGraph graph, std::span<const Clip> clips);

/// The same with each clip's frame durations, as `in_step` gives them.
struct MotionInStep {
  Clip clip;
  std::vector<double> frame_seconds;
};
MotionGraph with_motions(MotionGraph graph, std::span<const MotionInStep> motions);

/// A version of a motion put in step with another: frame for frame the same moment, by keytimes
/// (seconds, ascending, as many of each) that correspond, and how long each frame lasts there.
/// Throws mien::Error when the keytimes do not correspond or lie outside the clips.
MotionInStep in_step(const Clip& version, std::span<const double> version_keytimes,
                     const Clip& reference, std::span<const double> reference_keytimes);

}  // namespace mien::motion
