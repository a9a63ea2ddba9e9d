// Walks along paths: what the walkers do, how long and how far, and where their mood changes.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/methods/study_facts.h"

namespace mien::pipeline {

namespace {

/// Of more walks than these, only the ranges of lengths and durations are stated.
constexpr std::size_t most_described_walks = 8;

std::string side_text(double degrees) { return degrees < 0.0 ? "to the right" : "to the left"; }

/// "walked for 3 s in a curve of 20°/s to the left at 0.8 times the speed of its mood"
std::string step_text(const WalkStep& step) {
  std::string text;
  if (step.walk_s) text = "walked for " + shortest(*step.walk_s) + " s";
  if (step.turn_deg)
    text = fmt::format("turned by {}° {}", shortest(std::abs(*step.turn_deg)),
                       side_text(*step.turn_deg));
  if (step.stand_s) text = "stood for " + shortest(*step.stand_s) + " s";
  if (step.curve_deg_s != 0.0)
    text += fmt::format(" in a curve of {}°/s {}", shortest(std::abs(step.curve_deg_s)),
                        side_text(step.curve_deg_s));
  if (step.pace) text += " at " + shortest(*step.pace) + " times the speed of its mood";
  return text;
}

std::string course_text(const WalkPath& path) {
  if (!path.points.empty())
    return fmt::format("followed a path through {} points on the floor", path.points.size());
  Names steps;
  for (const WalkStep& step : path.script) steps.push_back(step_text(step));
  return listed(steps);
}

/// Metres that the pelvis covers over the floor.
double length_of(const motion::Clip& clip) {
  double length = 0.0;
  for (std::size_t f = 1; f < clip.poses.size(); ++f) {
    motion::Vec3 step = clip.poses[f].root_position - clip.poses[f - 1].root_position;
    step.y() = 0.0;
    length += step.norm();
  }
  return length;
}

/// "sad", "sad until 7.5 s, then happy"
std::string moods_text(const std::vector<ShownMood>& moods) {
  std::string text;
  for (std::size_t i = 0; i < moods.size(); ++i) {
    text += (i == 0 ? "" : ", then ") + motion::printable(moods[i].mood);
    if (i + 1 < moods.size()) text += fmt::format(" until {:.1f} s", moods[i + 1].from_s);
  }
  return text;
}

void describe_walk(const Stimulus& stimulus, MethodsText& out) {
  const Synthesis& made = out.motions.of(stimulus.id);
  const WalkPath& path = *stimulus.walk;
  const double seconds = made.motion.clip.duration_seconds();
  const double length = length_of(made.motion.clip);
  out.say(fmt::format(
      "In {}, the walker {}{} ({:.1f} m in {:.1f} s, {:.2f} m/s on average); its "
      "mood was {}",
      stimulus.id, course_text(path),
      path.pace == 1.0 ? "" : ", at " + shortest(path.pace) + " times the speed of its mood",
      length, seconds, length / std::max(seconds, 1e-9), moods_text(made.moods)));
}

void describe_walks(const std::vector<const Stimulus*>& walks, MethodsText& out) {
  if (walks.size() <= most_described_walks) {
    for (const Stimulus* stimulus : walks) describe_walk(*stimulus, out);
    return;
  }
  Range seconds, lengths;
  std::size_t changing = 0;
  for (const Stimulus* stimulus : walks) {
    const Synthesis& made = out.motions.of(stimulus->id);
    seconds.add(made.motion.clip.duration_seconds());
    lengths.add(length_of(made.motion.clip));
    changing += made.moods.size() > 1 ? 1 : 0;
  }
  out.say(fmt::format("The walks were {} long and lasted {}; the mood changed on the way in {}",
                      with_mean(lengths, 1, " m"), with_mean(seconds, 1, " s"),
                      changing == 0 ? "none of them" : count_of(changing, "of them", "of them")));
}

/// "the walks of builtin:walks-10 and adjectives"
std::string mood_kinds(const std::vector<const Stimulus*>& walks) {
  Names kinds;
  for (const Stimulus* stimulus : walks) {
    const WalkPath& path = *stimulus->walk;
    for (const auto& [place, mood] : places_of_moods(path)) {
      if (mood.empty()) continue;
      add_once(kinds, is_of_adjectives(path, mood)
                          ? "blends of these with given adjectives"
                          : "mixtures of the parametric walks of " + path.set);
    }
    if (moods_of(path).size() == 1 && kinds.empty())
      add_once(kinds, "mixtures of the parametric walks of " + path.set);
  }
  std::ranges::sort(kinds, std::greater{});
  return listed(kinds);
}

}  // namespace

void describe_paths(MethodsText& out) {
  std::vector<const Stimulus*> steered, guided;
  for (const Stimulus* stimulus : stimuli_from(out.manifest, "path"))
    (stimulus->walk->graph.empty() ? steered : guided).push_back(stimulus);
  if (!steered.empty()) {
    out.say(count_of(steered.size(), "stimulus was", "stimuli were") +
            " synthesized along a path by a parametric walker that plans each step, without "
            "recorded motion");
    out.say("Its moods were " + mood_kinds(steered) +
            "; footsteps are planned ahead, and a change of mood takes a few tenths of a second");
    describe_walks(steered, out);
  }
  if (guided.empty()) return;
  out.say(count_of(guided.size(), "stimulus was", "stimuli were") +
          " assembled along a path from recorded motions, which a search of their motion graph "
          "joined; moods are modifications of these motions");
  describe_walks(guided, out);
}

}  // namespace mien::pipeline
