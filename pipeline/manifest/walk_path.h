#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// A walker's style as a mixture of built-in walks: weights ≥ 0, not all 0; or which
/// adjectives of the built-in scales the walk has, each from 0 to 1. By a graph: how much of which
/// emotions' recipes its motions are given; what is missing to 1 is as captured.
using Mood = std::vector<std::pair<std::string, double>>;

/// One thing that a walker does: exactly one of walk, turn and stand is given.
struct WalkStep {
  std::optional<double> walk_s;    ///< seconds
  std::optional<double> turn_deg;  ///< to the left; below 0 to the right; not 0
  std::optional<double> stand_s;   ///< seconds, from when it has come to stand
  std::optional<double> pace;      ///< else that of the whole path, and of turns what came before
  double curve_deg_s = 0.0;        ///< of a walk: °/s to the left
  Mood mood;                       ///< from here on; none: as before

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

/// A mood that somebody walks in from a moment on.
struct MoodChange {
  double seconds = 0.0;  ///< since the beginning
  Mood mood;

  friend bool operator==(const MoodChange&, const MoodChange&) = default;
};

void fields_of(auto&& field, MaybeConst<MoodChange> auto& change) {
  field("at", change.seconds, concerns::motion | concerns::required);
  field("mood", change.mood, concerns::motion | concerns::required);
}

/// A place on the floor, metres: to the left of where the world's +Z goes, and along it.
using FloorPoint = std::array<double, 2>;

/// A motion of a graph.
struct GraphMotion {
  std::filesystem::path file;  ///< resolved
  std::string take;            ///< of a file with several; empty: its first

  friend bool operator==(const GraphMotion&, const GraphMotion&) = default;
};

void fields_of(auto&& field, MaybeConst<GraphMotion> auto& motion) {
  field("file", motion.file, concerns::motion | concerns::required | concerns::alone);
  field("take", motion.take, concerns::motion);
}

/// What a walker under control (motion/steered_walk/scripted_walk.h) is to do, from standing to
/// standing on a path, or step by step; or what is to be found for it among motions of files
/// (motion/motion_graph/guided_walk.h), which have their own moods and speeds. Exactly one of
/// script and points is given.
struct WalkPath {
  std::string set = "builtin:walks-10";  ///< that moods are named after
  Mood mood;          ///< at the beginning; none: that of the first step, or the set's first walk
  double pace = 1.0;  ///< share of the mood's own speed
  std::vector<WalkStep> script;
  std::vector<FloorPoint> points;  ///< of a path along straight lines, whose corners are rounded
  std::vector<MoodChange> moods;   ///< along the points, by time
  std::vector<GraphMotion> graph;  ///< none: the walker walks
  double threshold_m = 0.06;       ///< of the graph (motion/motion_graph/motion_graph.h)

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

/// `path:`: steps, or a map.
struct WalkPathForm {
  static void read(const DocumentValue& given, std::optional<WalkPath>& path);
  static nlohmann::ordered_json write(const std::optional<WalkPath>& path,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<WalkPath>(); }
};

/// Names of the walks that the set holds; none for a set that there is not.
std::vector<std::string> walks_of(const WalkPath& path);

/// Names of the adjectives that moods may be of: groups and pairs of the built-in scales.
std::vector<std::string> adjectives_of_moods();

/// Whether a mood is of adjectives and not of the set's walks.
bool is_of_adjectives(const WalkPath& path, const Mood& mood);

/// The walks or adjectives that the path's moods use, in the set's order; the set's first if none
/// is named.
std::vector<std::string> moods_of(const WalkPath& path);

/// A short description: "walk 3 s, turn 90°, stand 1 s like sad", "4.2 m over 3 points".
std::string described(const WalkPath& path);

/// All moods of the path with where each stands below it: "mood", "script[1].mood", "moods[0].mood"
/// (of a script alone "[1].mood").
std::vector<std::pair<std::string, Mood>> places_of_moods(const WalkPath& path);

/// Metres of the straight lines through the points.
double length_of(const std::vector<FloorPoint>& points);

}  // namespace mien::pipeline
