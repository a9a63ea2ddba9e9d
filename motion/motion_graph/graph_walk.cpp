#include "motion/motion_graph/graph_walk.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/gait/foot_lock.h"
#include "motion/math/random_number.h"
#include "motion/math/rotation.h"
#include "motion/motion_graph/transition_checks.h"

namespace mien::motion {

namespace {

constexpr double least_between = 0.5;  // seconds from transition to transition, of random walks

const Pose& pose_of_frame(const MotionGraph& graph, int clip, int frame) {
  return graph.clips[static_cast<std::size_t>(clip)].poses[static_cast<std::size_t>(frame)];
}

/// The step over the floor that leads to a frame of a clip; of the first frame the step after it.
Vec3 step_to(const MotionGraph& graph, int clip, int frame) {
  const int to = std::max(frame, 1);
  return level(pose_of_frame(graph, clip, to).root_position -
               pose_of_frame(graph, clip, to - 1).root_position);
}

Quat turned_by(double turn) { return Quat(Eigen::AngleAxisd(turn, Vec3::UnitY())); }

double blend_share(int frame, int window) {
  const double p = (frame + 1.0) / (window + 1.0);
  return 2.0 * p * p * p - 3.0 * p * p + 1.0;
}

double facing(const Quat& rotation) {
  const Vec3 forward = rotation * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z());
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

Clip untimed_clip(const MotionGraph& graph, const std::vector<WalkFrame>& frames,
                  const GraphWalkOptions& options) {
  Clip clip;
  clip.body = graph.clips.front().body;
  clip.frames_per_second = graph.clips.front().frames_per_second;
  const WalkFrame& first = frames.front();
  double turn =
      options.heading - facing(pose_of_frame(graph, first.clip, first.frame).rotations.front());
  Vec3 place = level(options.place);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const WalkFrame& frame = frames[f];
    // After a transition the clip that was entered is the one that is played.
    const bool arrived =
        f > 0 && frames[f - 1].to_clip >= 0 &&
        (frame.clip != frames[f - 1].clip || frame.frame != frames[f - 1].frame + 1);
    if (arrived) turn += frames[f - 1].turn;
    if (f > 0) place += step_of(graph, frame, turn);
    Pose pose = posture_of(graph, frame, turn);
    pose.root_position += place;
    clip.poses.push_back(std::move(pose));
  }
  return clip;
}

/// The clip at an even frame rate, when its frames last as long as the walk says.
Clip in_time(const MotionGraph& graph, const std::vector<WalkFrame>& frames, Clip clip) {
  if (graph.frame_seconds.empty()) return clip;
  std::vector<double> times = {0.0};
  for (const WalkFrame& frame : frames) times.push_back(times.back() + seconds_of(graph, frame));
  times.resize(clip.poses.size());
  std::vector<Pose> poses;
  std::size_t i = 0;
  for (int f = 0; f / clip.frames_per_second <= times.back() + 1e-9; ++f) {
    const double seconds = std::min(f / clip.frames_per_second, times.back());
    while (i + 2 < times.size() && times[i + 1] < seconds) ++i;
    if (times.size() == 1) break;
    const double t = std::clamp((seconds - times[i]) / (times[i + 1] - times[i]), 0.0, 1.0);
    poses.push_back(interpolate(clip.poses[i], clip.poses[i + 1], t));
  }
  clip.poses = std::move(poses);
  return clip;
}

/// Those of the plants that touch a transition.
std::vector<FootPlant> at_transitions(const std::vector<FootPlant>& plants,
                                      const std::vector<WalkFrame>& frames) {
  std::vector<FootPlant> touching;
  for (const FootPlant& plant : plants) {
    const auto first = frames.begin() + plant.first;
    if (std::any_of(first, frames.begin() + plant.last + 1,
                    [](const WalkFrame& frame) { return frame.to_clip >= 0; })) {
      touching.push_back(plant);
    }
  }
  return touching;
}

/// Locked until the feet stand: once is not always enough where the legs hardly reach.
Clip with_locked_feet(Clip clip, const std::vector<FootPlant>& plants) {
  constexpr double still_m = 0.002;
  constexpr int most_locks = 6;
  FootLockOptions lock;
  lock.keep_velocity = true;
  lock.extension = 0.995;
  for (int i = 0; i < most_locks && planted_drift(clip, plants) > still_m; ++i) {
    clip = foot_locked(clip, plants, lock);
  }
  return clip;
}

}  // namespace

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
      throw Error("a walk over a motion graph leaps from node to node",
                  "every edge has to begin where the one before ends");
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
  const FootStands stands = foot_stands(graph);
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
        stands_now = stands[clip][at][left];
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

Clip motion_of(const MotionGraph& graph, const GraphWalk& walk, const GraphWalkOptions& options) {
  const std::vector<WalkFrame> frames = frames_of(graph, walk);
  if (frames.empty()) throw Error("a walk over a motion graph without a frame", "give it an edge");
  Clip clip = untimed_clip(graph, frames, options);
  if (options.lock_feet)
    clip = with_locked_feet(clip, at_transitions(plants_of(graph, frames), frames));
  return in_time(graph, frames, std::move(clip));
}

GraphWalk random_walk(const MotionGraph& graph, double seconds, std::uint64_t seed) {
  if (!(seconds > 0.0) || seconds > 3600.0) {
    throw Error("a random walk that does not last between 0 and 3600 seconds",
                "choose its seconds");
  }
  GraphWalk walk;
  const double step = 1.0 / graph.clips.front().frames_per_second;
  double walked = 0.0;
  std::uint64_t draw = 0;
  const auto choose = [&](std::size_t count) {
    const double share = 0.5 + 0.5 * random_number(seed, "walk over a motion graph", draw++);
    return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
  };
  auto node = choose(graph.nodes.size());
  double since = 0.0;  // the last transition, seconds
  while (walked < seconds) {
    const std::vector<int>& leaving = graph.leaving[node];
    const bool goes_on = graph.edges[static_cast<std::size_t>(leaving.front())].transition < 0;
    const bool early = since < least_between && goes_on;
    const int edge = leaving[early ? 0 : choose(leaving.size())];
    walk.edges.push_back(edge);
    const GraphEdge& taken = graph.edges[static_cast<std::size_t>(edge)];
    walked += step * taken.frames;
    since = taken.transition >= 0 ? 0.0 : since + step * taken.frames;
    node = static_cast<std::size_t>(graph.edges[static_cast<std::size_t>(edge)].to);
  }
  return walk;
}

}  // namespace mien::motion
