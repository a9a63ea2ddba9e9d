#include "motion/motion_graph/guided_walk.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/math/percentile.h"
#include "motion/motion_graph/walk_search.h"
#include "motion/steered_walk/floor_path.h"

namespace mien::motion {

namespace {

constexpr double script_turning = 60.0;  // °/s

void check_options(const GuidedWalkOptions& options) {
  if (!(options.ahead_seconds > 0.0) || !(options.kept_seconds > 0.0) ||
      options.kept_seconds > options.ahead_seconds || !(options.between_seconds >= 0.0) ||
      options.most_edges < 1) {
    throw Error("a guided walk that looks ahead by nothing, or by less than it keeps",
                "2.5 s ahead and 0.8 s kept are usual");
  }
}

double facing_at(const MotionGraph& graph, const GraphNode& node) {
  const Clip& clip = graph.clips[static_cast<std::size_t>(node.clip)];
  const Vec3 forward =
      clip.poses[static_cast<std::size_t>(node.frame)].rotations.front() * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z());
}

/// Some nodes, evenly over the graph, placed at a start.
std::vector<WalkState> starts_at(const MotionGraph& graph, const Vec3& place, double heading) {
  constexpr std::size_t most = 60;
  std::vector<WalkState> starts;
  const std::size_t step = (graph.nodes.size() + most - 1) / most;
  for (std::size_t n = 0; n < graph.nodes.size(); n += step) {
    WalkState state;
    state.node = static_cast<int>(n);
    state.turn = heading - facing_at(graph, graph.nodes[n]);
    state.facing = heading;
    state.place = level(place);
    starts.push_back(state);
  }
  return starts;
}

/// Speed that only a tenth of the frames of the graph's clips exceed, m/s.
double brisk_speed(const MotionGraph& graph) {
  std::vector<double> speeds;
  for (const Clip& clip : graph.clips) {
    for (std::size_t f = 1; f < clip.poses.size(); ++f) {
      const Vec3 step = clip.poses[f].root_position - clip.poses[f - 1].root_position;
      speeds.push_back(level(step).norm() * clip.frames_per_second);
    }
  }
  return percentile(std::move(speeds), 90.0);
}

Clip clip_from(const MotionGraph& graph, const GraphWalk& walk, const Vec3& place, double heading) {
  // The search counts the step that leads to the first frame.
  const WalkFrame first = frames_of(graph, {{walk.edges.front()}}).front();
  const double turn = heading - facing_at(graph, {first.clip, first.frame});
  GraphWalkOptions options;
  options.place = place + step_of(graph, first, turn);
  options.heading = heading;
  return motion_of(graph, walk, options);
}

void refuse_straying(const FloorPath& path, const Clip& clip) {
  constexpr double lost = 1.0;  // metres
  double way = 0.0;
  for (const Pose& pose : clip.poses) {
    way = nearest_way(path, pose.root_position, way);
    if ((point_at(path, way) - level(pose.root_position)).norm() < lost) continue;
    throw Error("the motion graph strays from the path by more than a metre",
                "add motions that turn as the path does, or raise the graph's threshold");
  }
}

/// Speed and heading that a script asks for, moment by moment.
struct ScriptMoments {
  double seconds_each = 0.0;
  std::vector<double> speeds;    ///< m/s
  std::vector<double> headings;  ///< radians
};

ScriptMoments moments_of(std::span<const WalkSegment> script, double frame, double brisk) {
  ScriptMoments moments;
  moments.seconds_each = frame;
  double heading = 0.0;
  for (const WalkSegment& segment : script) {
    const bool turns = segment.kind == WalkSegment::Kind::turn;
    const double rate =
        turns ? std::copysign(script_turning, segment.degrees) : segment.turn_rate_deg;
    const double seconds = turns ? std::abs(segment.degrees) / script_turning : segment.seconds;
    if (!std::isfinite(seconds) || seconds < 0.0 || !std::isfinite(rate) ||
        !std::isfinite(segment.pace)) {
      throw Error("a walk's script with a number that is none, or a time below 0",
                  "give seconds, degrees and shares");
    }
    const bool stands = segment.kind == WalkSegment::Kind::stand;
    for (int f = 0; f < std::lround(seconds / frame); ++f) {
      heading += stands ? 0.0 : radians_per_degree * rate * frame;
      moments.speeds.push_back(stands ? 0.0 : segment.pace * brisk);
      moments.headings.push_back(heading);
    }
  }
  if (moments.speeds.empty())
    throw Error("an empty script for a walk", "give one segment at least");
  return moments;
}

}  // namespace

GuidedWalk walk_along(const MotionGraph& graph, std::span<const Vec3> polyline,
                      const GuidedWalkOptions& options) {
  check_options(options);
  const FloorPath path = floor_path(polyline);
  const double length = path.length();
  const double frame = 1.0 / graph.clips.front().frames_per_second;
  const double full_step = brisk_speed(graph) * frame;
  // A metre that is not walked costs as much as 0.2 m beside the path for a second.
  constexpr double idling = 0.04;
  const FrameCost cost = [&](WalkState& state, const Vec3&) {
    const double before = state.way;
    state.way = nearest_way(path, state.place, before);
    const double beside = (point_at(path, state.way) - state.place).squaredNorm();
    return frame * beside + idling * std::max(0.0, full_step - (state.way - before));
  };
  const WalkDone done = [&](const WalkState& state) { return state.way >= length - 0.05; };
  const double heading = heading_at(path, 0.3);
  GuidedWalk guided;
  guided.walk =
      searched_walk(graph, starts_at(graph, path.points.front(), heading), cost, done, options);
  guided.clip = clip_from(graph, guided.walk, path.points.front(), heading);
  refuse_straying(path, guided.clip);
  return guided;
}

GuidedWalk scripted_walk(const MotionGraph& graph, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options) {
  check_options(options);
  const double frame = 1.0 / graph.clips.front().frames_per_second;
  const ScriptMoments moments = moments_of(script, frame, brisk_speed(graph));
  constexpr double heading_weight = 1.5;  // m/s that a radian of heading weighs
  const FrameCost cost = [&](WalkState& state, const Vec3& step) {
    state.way = state.seconds;
    const auto at = std::min(static_cast<std::size_t>(std::lround(state.seconds / frame)),
                             moments.speeds.size()) -
                    1;
    const double speed = step.norm() / frame - moments.speeds[at];
    const double turn =
        heading_weight * std::remainder(state.facing - moments.headings[at], 2.0 * pi);
    return frame * (speed * speed + turn * turn);
  };
  const double end = frame * static_cast<double>(moments.speeds.size());
  const WalkDone done = [&](const WalkState& state) { return state.seconds >= end - 0.5 * frame; };
  GuidedWalk guided;
  guided.walk = searched_walk(graph, starts_at(graph, Vec3::Zero(), 0.0), cost, done, options);
  guided.clip = clip_from(graph, guided.walk, Vec3::Zero(), 0.0);
  return guided;
}

}  // namespace mien::motion
