#include "motion/motion_graph/guided_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/error.h"
#include "motion/math/percentile.h"
#include "motion/motion_graph/heading_correction.h"
#include "motion/motion_graph/walk_search.h"
#include "motion/steered_walk/floor_path.h"

namespace mien::motion {

namespace {

/// °/s of a turn in walking, and on the spot, where it takes steps of its own.
double turning_of(const WalkSegment& turn) { return turn.pace > 0.0 ? 60.0 : 45.0; }

void check_options(const GuidedWalkOptions& options) {
  if (!(options.ahead_seconds > 0.0) || !(options.kept_seconds > 0.0) ||
      options.kept_seconds > options.ahead_seconds || !(options.between_seconds >= 0.0) ||
      options.most_edges < 1) {
    throw Error("a guided walk looks ahead by zero seconds, or by less than it keeps",
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
    state.place = horizontal(place);
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
      speeds.push_back(horizontal(step).norm() * clip.frames_per_second);
    }
  }
  return percentile(std::move(speeds), 90.0);
}

/// Where the walk's clip is to begin so that the search's begins at a place and heading.
GraphWalkOptions beginning(const MotionGraph& graph, const GraphWalk& walk, const Vec3& place,
                           double heading) {
  // The search counts the step that leads to the first frame.
  const WalkFrame first = frames_of(graph, {{walk.edges.front()}}).front();
  const double turn = heading - facing_at(graph, {first.clip, first.frame});
  GraphWalkOptions options;
  options.place = place + step_of(graph, first, turn);
  options.heading = heading;
  return options;
}

void make_clip(const MixedGraph& mixed, const GraphWalkOptions& options, GuidedWalk& guided) {
  WalkedClip walked = walked_clip(mixed.versions, guided.walk, mixed.moods, options);
  guided.clip = std::move(walked.clip);
  guided.plants = std::move(walked.plants);
}

/// Leaves out what the last edge would go on beyond the path's end.
void end_with(const FloorPath& path, GuidedWalk& guided) {
  std::vector<Pose>& poses = guided.clip.poses;
  double way = 0.0;
  std::size_t frame = 0;
  while (frame + 1 < poses.size()) {
    way = nearest_way(path, poses[frame].root_position, way);
    if (way >= path.length() - path.step_m) break;
    ++frame;
  }
  poses.resize(frame + 1);
  const auto last = static_cast<int>(frame);
  std::erase_if(guided.plants, [&](const FootPlant& plant) { return plant.first > last; });
  for (FootPlant& plant : guided.plants) plant.last = std::min(plant.last, last);
}

void refuse_straying(const FloorPath& path, const Clip& clip) {
  constexpr double lost = 1.0;  // metres
  double way = 0.0;
  for (const Pose& pose : clip.poses) {
    way = nearest_way(path, pose.root_position, way);
    if ((point_at(path, way) - horizontal(pose.root_position)).norm() < lost) continue;
    throw Error("the motion graph strays from the path by more than a metre",
                "add motions with such turns, or raise the graph's threshold");
  }
}

/// Speed and heading that a script asks for, moment by moment.
struct ScriptMoments {
  double seconds_each = 0.0;
  std::vector<double> speeds;      ///< m/s
  std::vector<double> headings;    ///< radians
  std::vector<HeadingGoal> goals;  ///< at the ends of walks and stands, and at the last
  std::vector<double> starts;      ///< of the segments, seconds
  std::vector<MoodChange> moods;
};

void add_moments(const WalkSegment& segment, double brisk, ScriptMoments& moments) {
  const bool turns = segment.kind == WalkSegment::Kind::turn;
  const bool stands = segment.kind == WalkSegment::Kind::stand;
  const double rate =
      turns ? std::copysign(turning_of(segment), segment.degrees) : segment.turn_rate_deg;
  const double seconds = turns ? std::abs(segment.degrees) / turning_of(segment) : segment.seconds;
  if (!std::isfinite(seconds) || seconds < 0.0 || !std::isfinite(rate) ||
      !std::isfinite(segment.pace)) {
    throw Error("a walk script with an invalid number, or a time below 0",
                "give seconds, degrees and weights");
  }
  double heading = moments.headings.empty() ? 0.0 : moments.headings.back();
  const double start = static_cast<double>(moments.headings.size()) * moments.seconds_each;
  moments.starts.push_back(start);
  if (!segment.moods.empty()) moments.moods.push_back({start, segment.moods});
  for (int f = 0; f < std::lround(seconds / moments.seconds_each); ++f) {
    heading += stands ? 0.0 : radians_per_degree * rate * moments.seconds_each;
    moments.speeds.push_back(stands ? 0.0 : segment.pace * brisk);
    moments.headings.push_back(heading);
  }
}

/// Adds the goal at the end of a segment; for a turn only if it is the last, since otherwise the
/// next segment implies it.
void add_goal(std::span<const WalkSegment> script, std::size_t i, ScriptMoments& moments) {
  constexpr double gait_cycle = 1.0;  // seconds, in which the pelvis turns to and fro
  const WalkSegment& segment = script[i];
  const bool turns = segment.kind == WalkSegment::Kind::turn;
  if (moments.headings.empty() || (turns && i + 1 < script.size())) return;
  HeadingGoal goal;
  goal.seconds = static_cast<double>(moments.headings.size()) * moments.seconds_each;
  goal.radians = moments.headings.back();
  const bool stands = segment.kind == WalkSegment::Kind::stand;
  goal.over_seconds =
      turns ? 0.1 : std::clamp(0.5 * segment.seconds, 0.1, stands ? 0.3 : gait_cycle);
  if (segment.turn_rate_deg != 0.0) goal.over_seconds = 0.1;
  goal.segment = i;
  while (goal.segment > 0 && script[goal.segment].kind != WalkSegment::Kind::turn &&
         script[goal.segment].turn_rate_deg == 0.0) {
    --goal.segment;
  }
  if (!moments.goals.empty() && goal.seconds - moments.goals.back().seconds < 0.3) return;
  moments.goals.push_back(goal);
}

ScriptMoments moments_of(std::span<const WalkSegment> script, double frame, double brisk) {
  ScriptMoments moments;
  moments.seconds_each = frame;
  const auto sets_moods = [](const WalkSegment& segment) { return !segment.moods.empty(); };
  // Moods hold from the first change on, also before it.
  if (std::ranges::any_of(script, sets_moods) && !sets_moods(script.front()))
    moments.moods.push_back({0.0, {1.0}});
  for (std::size_t i = 0; i < script.size(); ++i) {
    add_moments(script[i], brisk, moments);
    add_goal(script, i, moments);
  }
  if (moments.speeds.empty())
    throw Error("an empty script for a walk", "give at least one segment");
  return moments;
}

/// The turn that is missed by most, if by enough.
std::optional<MissedTurn> missed_turn(const ScriptMoments& moments,
                                      const HeadingCorrection& correction) {
  constexpr double reported_deg = 5.0;
  std::optional<MissedTurn> worst;
  for (std::size_t w = 0; w < moments.goals.size(); ++w) {
    const double degrees = correction.missing[w] / radians_per_degree;
    if (std::abs(degrees) <= (worst ? std::abs(worst->degrees) : reported_deg)) continue;
    worst = MissedTurn{moments.goals[w].segment, degrees};
  }
  return worst;
}

}  // namespace

GuidedWalk walk_along(const MotionGraph& graph, std::span<const Vec3> polyline,
                      const GuidedWalkOptions& options) {
  return walk_along(std::span(&graph, 1), polyline, {}, options);
}

GuidedWalk walk_along(std::span<const MotionGraph> versions, std::span<const Vec3> polyline,
                      std::span<const MoodChange> moods, const GuidedWalkOptions& options) {
  check_options(options);
  const MixedGraph mixed{versions, moods};
  const MotionGraph& graph = mixed.graph();
  const FloorPath path = floor_path(polyline);
  const double length = path.length();
  const double frame = 1.0 / graph.clips.front().frames_per_second;
  const double full_step = brisk_speed(graph) * frame;
  // A metre that is not walked costs as much as 0.2 m beside the path for a second.
  constexpr double idling = 0.04;
  // Facing 0.3 rad away from the path costs as much as 0.1 m beside it: with a limited search
  // horizon the walk would otherwise end in the wrong direction.
  constexpr double facing_away = 0.1;  // m²/rad²
  const FrameCost cost = [&](WalkState& state, const Vec3&) {
    const double before = state.way;
    state.way = nearest_way(path, state.place, before);
    const double beside = (point_at(path, state.way) - state.place).squaredNorm();
    const double off = std::remainder(state.facing - heading_at(path, state.way), 2.0 * pi);
    const double amiss = frame * (beside + facing_away * off * off);
    return amiss + idling * std::max(0.0, full_step - (state.way - before));
  };
  const GoalReached done = [&](const WalkState& state) { return state.way >= length - 0.05; };
  const double heading = heading_at(path, 0.3);
  GuidedWalk guided;
  guided.walk =
      search_walk(mixed, starts_at(graph, path.points.front(), heading), cost, done, options);
  make_clip(mixed, beginning(graph, guided.walk, path.points.front(), heading), guided);
  end_with(path, guided);
  refuse_straying(path, guided.clip);
  return guided;
}

GuidedWalk scripted_walk(const MotionGraph& graph, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options) {
  std::vector<WalkSegment> plain(script.begin(), script.end());
  for (WalkSegment& segment : plain) segment.moods.clear();
  return scripted_walk(std::span(&graph, 1), plain, options);
}

GuidedWalk scripted_walk(std::span<const MotionGraph> versions, std::span<const WalkSegment> script,
                         const GuidedWalkOptions& options) {
  check_options(options);
  const MotionGraph& graph = versions.front();
  const double frame = 1.0 / graph.clips.front().frames_per_second;
  const ScriptMoments moments = moments_of(script, frame, brisk_speed(graph));
  const MixedGraph mixed{versions, moments.moods};
  constexpr double heading_weight = 2.5;  // m/s that a radian of heading weighs
  const FrameCost cost = [&](WalkState& state, const Vec3& step) {
    state.way = state.seconds;
    const auto at = std::clamp<long>(std::lround(state.seconds / frame) - 1, 0,
                                     static_cast<long>(moments.speeds.size()) - 1);
    const auto moment = static_cast<std::size_t>(at);
    const double speed = step.norm() / frame - moments.speeds[moment];
    const double turn =
        heading_weight * std::remainder(state.facing - moments.headings[moment], 2.0 * pi);
    return frame * (speed * speed + turn * turn);
  };
  const double end = frame * static_cast<double>(moments.speeds.size());
  const GoalReached done = [&](const WalkState& state) {
    return state.seconds >= end - 0.5 * frame;
  };
  GuidedWalk guided;
  guided.walk = search_walk(mixed, starts_at(graph, Vec3::Zero(), 0.0), cost, done, options);
  GraphWalkOptions begins = beginning(graph, guided.walk, Vec3::Zero(), 0.0);
  const HeadingCorrection correction =
      correct_headings(headings_of(versions, guided.walk, moments.moods, begins), moments.goals);
  begins.added_headings = correction.added;
  make_clip(mixed, begins, guided);
  guided.missed = missed_turn(moments, correction);
  guided.segment_starts = moments.starts;
  return guided;
}

}  // namespace mien::motion
