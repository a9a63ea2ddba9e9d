#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/recording_choice.h"

namespace mien::pipeline {

/// A walker's style: a mixture of built-in walks (weights ≥ 0, not all 0), or adjectives of the
/// built-in scales with values from 0 to 1. For a path through a motion graph: emotions and the
/// strengths of their recipes; the remainder to 1 is the captured motion.
using Mood = std::vector<std::pair<std::string, double>>;

/// One step of a walker's script. Exactly one of walk, turn and stand is given.
struct WalkStep {
  std::optional<double> walk_s;    ///< duration in seconds
  std::optional<double> turn_deg;  ///< rotation in degrees, positive to the left; not 0
  std::optional<double> stand_s;   ///< seconds, from when the walker has come to rest
  /// Factor on the mood's speed. Unset: for a walk, the pace of the path; for a turn, the pace of
  /// the preceding step (0 at the beginning and after standing).
  std::optional<double> pace;
  double curve_deg_s = 0.0;  ///< turning rate of a walk in degrees per second, positive to the left
  Mood mood;                 ///< mood from this step on; empty: unchanged

  friend bool operator==(const WalkStep&, const WalkStep&) = default;
};

void fields_of(auto&& field, MaybeConst<WalkStep> auto& step) {
  field("walk", step.walk_s, concerns::motion);
  field("turn", step.turn_deg, concerns::motion);
  field("stand", step.stand_s, concerns::motion);
  field("pace", step.pace, concerns::motion);
  field("curve", step.curve_deg_s, concerns::motion);
  field("mood", step.mood, concerns::motion);
}

/// A change of mood at a given time.
struct MoodChange {
  double seconds = 0.0;  ///< time since the beginning
  Mood mood;

  friend bool operator==(const MoodChange&, const MoodChange&) = default;
};

void fields_of(auto&& field, MaybeConst<MoodChange> auto& change) {
  field("at", change.seconds, concerns::motion | concerns::required);
  field("mood", change.mood, concerns::motion | concerns::required);
}

/// A mood in which a walk is shown from a time on, until that of the next one.
struct ShownMood {
  double from_s = 0.0;  ///< seconds of what is shown; 0 of the first
  std::string mood;     ///< in words: "sad", "0.6 sad and 0.4 tired"

  friend bool operator==(const ShownMood&, const ShownMood&) = default;
};

/// A position on the floor, metres: {x, z}, with +Z ahead and +X to the left.
using FloorPoint = std::array<double, 2>;

/// A motion of a motion graph.
struct GraphMotion {
  std::filesystem::path file;  ///< resolved
  RecordingChoice how;         ///< which motion of the file

  friend bool operator==(const GraphMotion&, const GraphMotion&) = default;
};

void fields_of(auto&& field, MaybeConst<GraphMotion> auto& motion) {
  field("file", motion.file, concerns::motion | concerns::required | concerns::alone);
  recording_fields(field, motion.how, concerns::motion);
}

/// A path for the steered walker (motion/steered_walk/scripted_walk.h), starting and ending in a
/// standing pose, or for a walk assembled from the motions of a graph
/// (motion/motion_graph/guided_walk.h); in the latter case, moods are emotions (see Mood), and
/// speeds are those of the motions. Exactly one of script and points is given.
struct WalkPath {
  std::string set = "builtin:walks-10";  ///< example set whose walks the moods name
  /// Initial mood; empty: that of the first step or, if it has none, the first walk of the set (in
  /// a motion graph: the captured motions).
  Mood mood;
  double pace = 1.0;  ///< factor on the mood's own speed
  std::vector<WalkStep> script;
  std::vector<FloorPoint> points;  ///< vertices of a polyline path with rounded corners
  std::vector<MoodChange> moods;   ///< changes of mood along the points, by time
  std::vector<GraphMotion> graph;  ///< motions of the graph; empty: the steered walker
  /// Transition threshold of the graph, metres (motion/motion_graph/motion_graph.h).
  double threshold_m = 0.06;

  friend bool operator==(const WalkPath&, const WalkPath&) = default;
};

void fields_of(auto&& field, MaybeConst<WalkPath> auto& path) {
  field("set", path.set, concerns::motion);
  field("mood", path.mood, concerns::motion);
  field("pace", path.pace, concerns::motion);
  field("script", path.script, concerns::motion);
  field("points", path.points, concerns::motion);
  field("moods", path.moods, concerns::motion);
  field("graph", path.graph, concerns::motion);
  field("threshold_m", path.threshold_m, concerns::motion);
}

/// `path:`: a list of steps or a map.
struct WalkPathForm {
  static void read(const DocumentValue& given, std::optional<WalkPath>& path);
  static nlohmann::ordered_json write(const std::optional<WalkPath>& path,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<WalkPath>(); }
};

/// Returns the names of the walks in the path's set; empty for an unknown set.
std::vector<std::string> walks_of(const WalkPath& path);

/// Returns the names that moods of adjectives may use: groups and pairs of the built-in scales.
std::vector<std::string> adjectives_of_moods();

/// Whether a mood consists of adjectives instead of walks of the set.
bool is_of_adjectives(const WalkPath& path, const Mood& mood);

/// Returns the walks that the path's moods name, in the set's order, without adjectives. The set's
/// first walk is included if neither the path nor its first step states a mood.
std::vector<std::string> moods_of(const WalkPath& path);

/// Returns a short description: "walk 3 s, turn 90°, stand 1 s like sad", "4.2 m over 3 points".
std::string described(const WalkPath& path);

/// Returns the moods of a walk in the order of time; successive ones differ, and the first begins
/// at 0. `segment_starts`: of a script, the time at which each step begins, seconds; changes along
/// points have their own times.
std::vector<ShownMood> moods_in_order(const WalkPath& path,
                                      const std::vector<double>& segment_starts);

/// Returns all moods of the walk, each with its key in the document below `path:`: "mood",
/// "script[1].mood", "moods[0].mood" ("[1].mood" if `path:` is a list of steps).
std::vector<std::pair<std::string, Mood>> places_of_moods(const WalkPath& path);

/// Returns the length of the polyline through the points, in metres.
double length_of(const std::vector<FloorPoint>& points);

}  // namespace mien::pipeline
