#include "motion/motion_graph/walk_frames.h"

#include <algorithm>

#include "motion/error.h"
#include "motion/motion_graph/transition_checks.h"

namespace mien::motion {

namespace {

const Pose& pose_of_frame(const MotionGraph& graph, int clip, int frame) {
  return graph.clips[static_cast<std::size_t>(clip)].poses[static_cast<std::size_t>(frame)];
}

/// The step over the floor that leads to a frame of a clip; of the first frame the step after it.
Vec3 step_to(const MotionGraph& graph, int clip, int frame) {
  const int to = std::max(frame, 1);
  return horizontal(pose_of_frame(graph, clip, to).root_position -
                    pose_of_frame(graph, clip, to - 1).root_position);
}

Quat turned_by(double turn) { return Quat(Eigen::AngleAxisd(turn, Vec3::UnitY())); }

}  // namespace

std::vector<double> requested_shares(std::span<const MoodChange> moods, double seconds,
                                     std::size_t versions) {
  std::vector<double> shares(versions, 0.0);
  shares.front() = 1.0;
  for (const MoodChange& from : moods) {
    if (from.seconds > seconds && &from != &moods.front()) continue;
    double sum = 0.0;
    for (const double weight : from.moods) sum += weight;
    for (std::size_t v = 0; v < versions; ++v) {
      shares[v] = v < from.moods.size() ? from.moods[v] / sum : 0.0;
    }
  }
  return shares;
}

double blend_share(int frame, int window) {
  const double p = (frame + 1.0) / (window + 1.0);
  return 2.0 * p * p * p - 3.0 * p * p + 1.0;
}

double seconds_of(const MotionGraph& graph, const WalkFrame& frame) {
  const auto of_clip = [&](int clip, int at) {
    if (graph.frame_seconds.empty()) return 1.0 / graph.clips.front().frames_per_second;
    return graph.frame_seconds[static_cast<std::size_t>(clip)][static_cast<std::size_t>(at)];
  };
  const double seconds = of_clip(frame.clip, frame.frame);
  if (frame.to_clip < 0) return seconds;
  return frame.share * seconds + (1.0 - frame.share) * of_clip(frame.to_clip, frame.to_frame);
}

Pose posture_of(const MotionGraph& graph, const WalkFrame& frame, double turn) {
  Pose pose = pose_of_frame(graph, frame.clip, frame.frame);
  pose.rotations.front() = turned_by(turn) * pose.rotations.front();
  if (frame.to_clip >= 0) {
    Pose to = pose_of_frame(graph, frame.to_clip, frame.to_frame);
    to.rotations.front() = turned_by(turn + frame.turn) * to.rotations.front();
    pose = interpolate(pose, to, 1.0 - frame.share);
  }
  pose.root_position = Vec3(0.0, pose.root_position.y(), 0.0);
  return pose;
}

Vec3 step_of(const MotionGraph& graph, const WalkFrame& frame, double turn) {
  const Vec3 step = turned_by(turn) * step_to(graph, frame.clip, frame.frame);
  if (frame.to_clip < 0) return step;
  const Vec3 other = turned_by(turn + frame.turn) * step_to(graph, frame.to_clip, frame.to_frame);
  return frame.share * step + (1.0 - frame.share) * other;
}

std::vector<WalkFrame> frames_of(const MotionGraph& graph, const GraphWalk& walk) {
  std::vector<WalkFrame> frames;
  int node = -1;
  for (const int number : walk.edges) {
    const GraphEdge& edge = graph.edges.at(static_cast<std::size_t>(number));
    if (node >= 0 && edge.from != node) {
      throw Error("consecutive edges of a walk over a motion graph are not connected",
                  "each edge must begin where the previous one ends");
    }
    node = edge.to;
    const GraphNode& from = graph.nodes[static_cast<std::size_t>(edge.from)];
    for (int f = 0; f < edge.frames; ++f) {
      WalkFrame frame;
      frame.clip = from.clip;
      frame.frame = from.frame + f;
      if (edge.transition >= 0) {
        const GraphTransition& way = graph.transitions[static_cast<std::size_t>(edge.transition)];
        frame.to_clip = way.to_clip;
        frame.to_frame = way.to_frame + f;
        frame.share = blend_share(f, graph.window);
        frame.turn = way.turn;
      }
      frames.push_back(frame);
    }
  }
  return frames;
}

std::vector<FootPlant> plants_of(const MotionGraph& graph, const std::vector<WalkFrame>& frames) {
  const FootContacts contacts = foot_contacts(graph);
  std::vector<FootPlant> plants;
  for (const bool left : {true, false}) {
    int first = -1;
    const auto count = static_cast<int>(frames.size());
    for (int f = 0; f <= count; ++f) {
      bool stands_now = false;
      if (f < count) {
        const WalkFrame& frame = frames[static_cast<std::size_t>(f)];
        const bool entered = frame.to_clip >= 0 && frame.share < 0.5;
        const auto clip = static_cast<std::size_t>(entered ? frame.to_clip : frame.clip);
        const auto at = static_cast<std::size_t>(entered ? frame.to_frame : frame.frame);
        stands_now = contacts[clip][at][left];
      }
      if (stands_now && first < 0) first = f;
      if (!stands_now && first >= 0) {
        if (f - first > 2) plants.push_back({left, first, f - 1});
        first = -1;
      }
    }
  }
  return plants;
}

}  // namespace mien::motion
