#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "motion/text/nearest_word.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/take_checks.h"

namespace mien::pipeline {

namespace {

constexpr double longest_walk_s = 600.0;
constexpr double nearest_points_m = 0.05;
constexpr double slowest_pace = 0.05;
constexpr double slow_walk_m_s = 1.0;  // a slow walk, to estimate durations
constexpr double turn_deg_s = 70.0;    // about as quickly as a walker turns

/// What moods may be named after; nothing where recipes say (resolve_modifications).
std::vector<std::string> names_of_moods(const WalkPath& walk) {
  return walk.graph.empty() ? walks_of(walk) : std::vector<std::string>();
}

std::vector<std::string> walks_and_adjectives(std::vector<std::string> walks,
                                              const std::vector<std::string>& adjectives) {
  walks.insert(walks.end(), adjectives.begin(), adjectives.end());
  return walks;
}

void check_adjectives(const std::string& path, const Mood& mood, const auto& is_adjective,
                      FaultList& list) {
  for (const auto& [name, value] : mood) {
    if (!is_adjective(name)) {
      list.add_at_key(member_path(path, name),
                      "this is not an adjective, but the other names of this mood are",
                      "name adjectives or walks, not both");
    } else if (value > 1.0) {
      list.add(member_path(path, name), "adjectives range from 0 to 1", "use at most 1");
    }
  }
}

void check_mood(const std::string& path, const Mood& mood, const std::vector<std::string>& walks,
                FaultList& list) {
  if (mood.empty() || walks.empty()) return;
  const std::vector<std::string> adjectives = adjectives_of_moods();
  const auto is_adjective = [&](const std::string& name) {
    return std::ranges::find(adjectives, name) != adjectives.end() &&
           std::ranges::find(walks, name) == walks.end();
  };
  if (std::ranges::any_of(mood, is_adjective, &Mood::value_type::first))
    return check_adjectives(path, mood, is_adjective, list);
  for (const auto& [name, weight] : mood) {
    if (std::ranges::find(walks, name) != walks.end()) continue;
    list.add_at_key(member_path(path, name), "the set has no walk of this name",
                    motion::did_you_mean(name, walks_and_adjectives(walks, adjectives)));
  }
  const auto is_positive = [](const auto& one) { return one.second > 0.0; };
  if (std::ranges::none_of(mood, is_positive))
    list.add(path, "all weights are 0", "give at least one walk a weight");
}

void check_step(const std::string& path, const WalkStep& step, FaultList& list) {
  if (step.walk_s && step.pace && *step.pace < slowest_pace) {
    list.add(member_path(path, "pace"), "this is too slow for a walk",
             fmt::format("use a pace of at least {}, or stand: instead of walk:", slowest_pace));
  }
  if (step.stand_s && step.pace) {
    list.add(member_path(path, "pace"), "standing has no pace", "omit it, or use walk:");
  }
  if (!step.walk_s && step.curve_deg_s != 0.0) {
    list.add(member_path(path, "curve"), "only walks can follow a curve",
             "use it in a step with walk:, or use turn: with the total degrees");
  }
  if (step.turn_deg && *step.turn_deg == 0.0) {
    list.add(member_path(path, "turn"), "this is not a turn",
             "give degrees: above 0 to the left, below 0 to the right");
  }
}

double seconds_of(const WalkStep& step) {
  return step.walk_s.value_or(0.0) + step.stand_s.value_or(0.0) +
         std::abs(step.turn_deg.value_or(0.0)) / turn_deg_s;
}

/// Refuses a script or points that would take longer than `longest_walk_s`.
void check_length(const std::string& path, double seconds, FaultList& list) {
  if (seconds <= longest_walk_s) return;
  list.add(path,
           fmt::format("this would take about {:.0f} minutes; the maximum is {:.0f}",
                       std::ceil(seconds / 60.0), longest_walk_s / 60.0),
           "shorten it, or split it into several stimuli");
}

void check_script(const std::string& path, const WalkPath& walk, FaultList& list) {
  const std::string map = member_path(path, "script");
  const std::string script = list.was_given(map) ? map : path;
  const std::vector<std::string> walks = names_of_moods(walk);
  double seconds = 0.0;
  for (std::size_t i = 0; i < walk.script.size(); ++i) {
    const std::string step = element_path(script, i);
    check_step(step, walk.script[i], list);
    check_mood(member_path(step, "mood"), walk.script[i].mood, walks, list);
    seconds += seconds_of(walk.script[i]);
  }
  check_length(script, seconds, list);
  if (!walk.moods.empty()) {
    list.add(member_path(path, "moods"), "in a script, moods belong to steps",
             "give mood: to the steps at which it begins");
  }
}

void check_points(const std::string& path, const WalkPath& walk, FaultList& list) {
  const std::string points = member_path(path, "points");
  const std::vector<std::string> walks = names_of_moods(walk);
  for (std::size_t i = 1; i < walk.points.size(); ++i) {
    const double apart = length_of({walk.points[i - 1], walk.points[i]});
    if (apart >= nearest_points_m) continue;
    list.add(element_path(points, i),
             fmt::format("only {:.0f} mm from the point before", 1000.0 * apart),
             fmt::format("remove it, or put it at least {:.0f} cm away (points are in metres)",
                         100.0 * nearest_points_m));
  }
  const double usual = length_of(walk.points) / (slow_walk_m_s * std::max(slowest_pace, walk.pace));
  check_length(points, usual, list);
  const double longest = 2.0 * usual + 10.0;  // sad, with turns, a start and a stop
  for (std::size_t i = 0; i < walk.moods.size(); ++i) {
    const std::string change = element_path(member_path(path, "moods"), i);
    check_mood(member_path(change, "mood"), walk.moods[i].mood, walks, list);
    if (walk.moods[i].seconds > longest) {
      list.add(member_path(change, "at"),
               fmt::format("the walk ends earlier, after at most {:.0f} s", longest),
               "use a time during the walk");
    }
    if (i == 0 || walk.moods[i].seconds > walk.moods[i - 1].seconds) continue;
    list.add(member_path(change, "at"), "this is not later than the previous change",
             "list changes of mood in order of time");
  }
}

/// Motions of files have a speed of their own.
void check_graph(const std::string& path, const WalkPath& walk, FaultList& list) {
  const std::string graph = member_path(path, "graph");
  for (std::size_t i = 0; i < walk.graph.size(); ++i) {
    const auto& [file, how] = walk.graph[i];
    check_motion_file(element_path(graph, i), file, read_options(how), list);
  }
  const auto refuse = [&](const std::string& at) {
    if (!list.was_given(at)) return;
    list.add(at, "motion files have their own pace",
             "omit it, or omit graph: to use the built-in walks");
  };
  if (walk.graph.empty()) {
    const std::string threshold = member_path(path, "threshold_m");
    if (list.was_given(threshold))
      list.add(threshold, "only graphs have this key", "add graph: with motion files");
    return;
  }
  for (const char* key : {"set", "pace"}) refuse(member_path(path, key));
}

}  // namespace

void check_walk_path(const Stimulus& stimulus, FaultList& list) {
  if (!stimulus.walk) return;
  const WalkPath& walk = *stimulus.walk;
  const std::string path = member_path(stimulus.path, "path");
  check_graph(path, walk, list);
  check_mood(member_path(path, "mood"), walk.mood, names_of_moods(walk), list);
  if (walk.points.empty()) {
    check_script(path, walk, list);
  } else {
    check_points(path, walk, list);
  }
}

}  // namespace mien::pipeline
