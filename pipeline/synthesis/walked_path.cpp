#include "pipeline/synthesis/walked_path.h"

#include <algorithm>
#include <vector>

#include "motion/formats/motion_file.h"
#include "motion/motion_graph/guided_walk.h"
#include "motion/motion_graph/motion_graph.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/retarget.h"
#include "motion/steered_walk/scripted_walk.h"

namespace mien::pipeline {

namespace {

using Moods = std::vector<std::string>;

motion::WalkerGaits gaits_of(const WalkPath& path, const Moods& moods) {
  std::vector<motion::WalkStyle> styles;
  const std::string set = path.set.substr(path.set.find(':') + 1);
  for (const motion::NamedStyle& walk : motion::builtin_styles(set)) {
    if (std::ranges::find(moods, walk.name) != moods.end()) styles.push_back(walk.style);
  }
  return motion::fit_walker(styles, motion::standard_body());
}

/// One share a mood that the walker has; none where the mood is not said.
std::vector<double> shares(const Mood& mood, const Moods& moods) {
  if (mood.empty()) return {};
  std::vector<double> result(moods.size(), 0.0);
  for (const auto& [name, share] : mood) {
    const auto found = std::ranges::find(moods, name);
    if (found != moods.end()) result[static_cast<std::size_t>(found - moods.begin())] = share;
  }
  return result;
}

std::vector<motion::WalkSegment> segments_of(const WalkPath& path, const Moods& moods) {
  using Kind = motion::WalkSegment::Kind;
  std::vector<motion::WalkSegment> segments;
  double pace = 0.0;  // of what is walked now
  for (const WalkStep& step : path.script) {
    motion::WalkSegment segment;
    segment.kind = step.walk_s ? Kind::walk : step.turn_deg ? Kind::turn : Kind::stand;
    segment.seconds = step.walk_s.value_or(step.stand_s.value_or(0.0));
    segment.degrees = step.turn_deg.value_or(0.0);
    segment.turn_rate_deg = step.curve_deg_s;
    if (step.walk_s) pace = path.pace;
    if (step.stand_s) pace = 0.0;
    pace = step.pace.value_or(pace);
    segment.pace = pace;
    segment.moods = shares(step.mood, moods);
    segments.push_back(segment);
  }
  return segments;
}

/// The mood it begins in, and those that follow by time.
std::vector<motion::MoodFrom> moods_in_time(const WalkPath& path, const Moods& moods) {
  const bool is_first_step_s = path.mood.empty() && !path.script.empty();
  const Mood& first = is_first_step_s ? path.script.front().mood : path.mood;
  std::vector<motion::MoodFrom> changes = {{0.0, shares(first, moods)}};
  for (const MoodChange& change : path.moods)
    changes.push_back({change.seconds, shares(change.mood, moods)});
  return changes;
}

std::vector<motion::Vec3> places_of(const WalkPath& path) {
  std::vector<motion::Vec3> points;
  for (const auto& [x, z] : path.points) points.emplace_back(x, 0.0, z);
  return points;
}

/// The files' motions, whole, at one frame rate and on one body.
std::vector<motion::Clip> clips_of(const WalkPath& path, double frames_per_second) {
  std::vector<motion::Clip> clips;
  for (const std::filesystem::path& file : path.graph) {
    const motion::Recording recording = motion::read_motion(file);
    motion::Clip clip = motion::to_body(recording, motion::recognise(recording));
    if (!clips.empty()) clip = motion::retarget(clip, clips.front().body);
    clips.push_back(motion::resampled(clip, frames_per_second));
    clips.back().name = file.stem().string();
  }
  return clips;
}

motion::Clip walked_by_graph(const WalkPath& path, double frames_per_second) {
  const motion::MotionGraph graph =
      motion::motion_graph(clips_of(path, frames_per_second), {.threshold_m = path.threshold_m});
  if (path.points.empty()) return motion::scripted_walk(graph, segments_of(path, {})).clip;
  return motion::walk_along(graph, places_of(path)).clip;
}

}  // namespace

motion::Clip walked(const WalkPath& path, double frames_per_second) {
  if (!path.graph.empty()) return walked_by_graph(path, frames_per_second);
  const Moods moods = moods_of(path);
  const motion::WalkerGaits gaits = gaits_of(path, moods);
  const motion::ScriptedWalkOptions options{.frames_per_second = frames_per_second,
                                            .moods = moods_in_time(path, moods)};
  if (path.points.empty()) return motion::scripted_walk(gaits, segments_of(path, moods), options);
  return motion::walk_along(gaits, places_of(path), path.pace, options);
}

}  // namespace mien::pipeline
