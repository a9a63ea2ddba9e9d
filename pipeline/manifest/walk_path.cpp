#include "pipeline/manifest/walk_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

namespace {

constexpr std::string_view set_prefix = "builtin:";

/// Whether it says nothing but what is done step by step.
bool is_script_alone(const WalkPath& path) {
  WalkPath plain;
  plain.script = path.script;
  return !path.script.empty() && path == plain;
}

std::string described(const Mood& mood) {
  std::string text;
  for (const auto& [name, weight] : mood) {
    text += text.empty() ? " like " : " and ";
    if (mood.size() > 1) text += shortest(weight) + " ";
    text += name;
  }
  return text;
}

std::string described(const WalkStep& step) {
  std::string text;
  if (step.walk_s) text = "walk " + shortest(*step.walk_s) + " s";
  if (step.turn_deg) text = "turn " + shortest(*step.turn_deg) + "°";
  if (step.stand_s) text = "stand " + shortest(*step.stand_s) + " s";
  if (step.curve_deg_s != 0.0) text += " in a curve of " + shortest(step.curve_deg_s) + "°/s";
  if (step.pace) text += " at pace " + shortest(*step.pace);
  return text + described(step.mood);
}

/// "sad", "0.6 sad and 0.4 tired", "0.8 quickness": a single walk is itself, whatever its weight.
std::string mood_words(const WalkPath& path, Mood mood) {
  std::erase_if(mood, [](const auto& one) { return one.second == 0.0; });
  const bool is_walk = mood.size() == 1 && path.graph.empty() && !is_of_adjectives(path, mood);
  if (is_walk) return mood.front().first;
  std::string text;
  for (const auto& [name, weight] : mood)
    text += (text.empty() ? "" : " and ") + shortest(weight) + " " + name;
  return text;
}

/// The mood in which it begins.
std::string first_mood_words(const WalkPath& path) {
  const Mood& first = !path.script.empty() && !path.script.front().mood.empty()
                          ? path.script.front().mood
                          : path.mood;
  if (!first.empty()) return mood_words(path, first);
  if (!path.graph.empty()) return "as captured";
  const std::vector<std::string> walks = walks_of(path);
  return walks.empty() ? "" : walks.front();
}

}  // namespace

void WalkPathForm::read(const DocumentValue& given, std::optional<WalkPath>& path) {
  path.emplace();
  if (given.value.is_array()) return pipeline::read(given, path->script);
  pipeline::read(given, *path);
}

OrderedJson WalkPathForm::write(const std::optional<WalkPath>& path, const WritingOptions& how) {
  if (!path) return {};
  return is_script_alone(*path) ? written(path->script, how) : written(*path, how);
}

std::vector<std::string> walks_of(const WalkPath& path) {
  if (!path.set.starts_with(set_prefix)) return {};
  const std::string name = path.set.substr(set_prefix.size());
  const auto known = motion::builtin_set_names();
  if (std::ranges::find(known, name) == known.end()) return {};
  return motion::builtin_example_names(name);
}

std::vector<std::string> adjectives_of_moods() {
  const ScaleSet scales = builtin_scales();
  std::vector<std::string> names;
  for (const ScaleGroup& group : scales.groups) names.push_back(group.id);
  for (const Scale& scale : scales.scales) names.push_back(scale.id);
  return names;
}

bool is_of_adjectives(const WalkPath& path, const Mood& mood) {
  if (!path.graph.empty()) return false;
  const std::vector<std::string> walks = walks_of(path);
  return std::ranges::any_of(
      mood, [&](const auto& one) { return std::ranges::find(walks, one.first) == walks.end(); });
}

std::vector<std::string> moods_of(const WalkPath& path) {
  const std::vector<std::string> walks = walks_of(path);
  std::vector<std::string> named;
  const auto add = [&](const Mood& mood) {
    for (const auto& one : mood) named.push_back(one.first);
  };
  add(path.mood);
  for (const WalkStep& step : path.script) add(step.mood);
  for (const MoodChange& change : path.moods) add(change.mood);
  const bool starts_plain =
      path.mood.empty() && (path.script.empty() || path.script.front().mood.empty());
  std::vector<std::string> moods;
  for (const std::string& walk : walks) {
    const bool is_first = &walk == &walks.front() && starts_plain;
    if (is_first || std::ranges::find(named, walk) != named.end()) moods.push_back(walk);
  }
  return moods;
}

std::string described(const WalkPath& path) {
  std::string text;
  for (const WalkStep& step : path.script) text += (text.empty() ? "" : ", ") + described(step);
  if (!path.points.empty()) {
    text = fmt::format("{:.1f} m over {} points", length_of(path.points), path.points.size());
  }
  if (path.pace != 1.0) text += " at pace " + shortest(path.pace);
  text += described(path.mood);
  if (!path.graph.empty()) text += fmt::format(" by a graph of {} files", path.graph.size());
  for (const MoodChange& change : path.moods)
    text += ", from " + shortest(change.seconds) + " s" + described(change.mood);
  return text;
}

std::vector<ShownMood> moods_in_order(const WalkPath& path,
                                      const std::vector<double>& segment_starts) {
  std::vector<ShownMood> moods = {{0.0, first_mood_words(path)}};
  const auto change = [&](double seconds, const Mood& mood) {
    const std::string words = mood_words(path, mood);
    if (mood.empty() || words == moods.back().mood) return;
    if (seconds <= moods.back().from_s)
      moods.back().mood = words;
    else
      moods.push_back({seconds, words});
  };
  for (std::size_t i = 1; i < std::min(path.script.size(), segment_starts.size()); ++i)
    change(segment_starts[i], path.script[i].mood);
  for (const MoodChange& one : path.moods) change(one.seconds, one.mood);
  return moods;
}

std::vector<std::pair<std::string, Mood>> places_of_moods(const WalkPath& path) {
  std::vector<std::pair<std::string, Mood>> moods = {{"mood", path.mood}};
  const std::string script = is_script_alone(path) ? "" : "script";
  for (std::size_t i = 0; i < path.script.size(); ++i)
    moods.emplace_back(fmt::format("{}[{}].mood", script, i), path.script[i].mood);
  for (std::size_t i = 0; i < path.moods.size(); ++i)
    moods.emplace_back(fmt::format("moods[{}].mood", i), path.moods[i].mood);
  return moods;
}

double length_of(const std::vector<FloorPoint>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += std::hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
  return length;
}

}  // namespace mien::pipeline
