#include "pipeline/production/synthesis/walked_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "motion/formats/motion_file.h"
#include "motion/interpolation/interpolation.h"
#include "motion/modify/modification.h"
#include "motion/motion_graph/guided_walk.h"
#include "motion/motion_graph/motion_graph.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/retarget.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/parameter_request.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/slider_interface.h"

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
std::vector<motion::MoodChange> moods_in_time(const WalkPath& path, const Moods& moods) {
  const bool is_first_step_s = path.mood.empty() && !path.script.empty();
  const Mood& first = is_first_step_s ? path.script.front().mood : path.mood;
  std::vector<motion::MoodChange> changes = {{0.0, shares(first, moods)}};
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
  for (const auto& [file, how] : path.graph) {
    const motion::Recording recording = motion::read_motion(file, read_options(how));
    motion::Clip clip = motion::to_body(recording, motion::recognise(recording));
    if (!clips.empty()) clip = motion::retarget(clip, clips.front().body);
    clips.push_back(motion::resampled(clip, frames_per_second));
    clips.back().name = file.stem().string();
  }
  return clips;
}

/// Shares of a graph's versions: the motions as they are, then each of the recipes.
std::vector<double> version_shares(const Mood& mood, const std::vector<ModificationStep>& recipes) {
  std::vector<double> result(recipes.size() + 1, 0.0);
  double sum = 0.0;
  for (const auto& [name, share] : mood) {
    const auto found = std::ranges::find(recipes, name, &ModificationStep::emotion);
    result[static_cast<std::size_t>(found - recipes.begin()) + 1] = share;
    sum += share;
  }
  result.front() = std::max(0.0, 1.0 - sum);
  return result;
}

/// The clip given an emotion, frame for frame the same moments.
motion::SynchronisedMotion in_emotion(const motion::Clip& clip, const ModificationStep& recipe) {
  motion::Modification walking = recipe.modification;
  walking.gesture = {};  // it would make the clip longer in the middle
  const motion::ModifiedClip modified = motion::modify(clip, walking);
  const motion::Clip& changed = modified.clip;
  const motion::Retiming& retiming = modified.report.retiming;
  std::vector<double> whole = {0.0, changed.duration_seconds()};
  std::vector<double> before = {0.0, clip.duration_seconds()};
  if (!retiming.is_even && !retiming.targets.empty()) {
    whole = retiming.targets;
    before.clear();
    for (std::size_t f = 0; f < whole.size(); ++f) {
      whole[f] /= changed.frames_per_second;
      before.push_back(static_cast<double>(f) / clip.frames_per_second);
    }
  }
  motion::SynchronisedMotion motion = motion::synchronised(changed, whole, clip, before);
  motion.clip.name = clip.name;
  return motion;
}

/// The graph as it is, and all of its motions in each of the emotions.
std::vector<motion::MotionGraph> versions_of(const motion::MotionGraph& graph,
                                             const std::vector<ModificationStep>& recipes) {
  std::vector<motion::MotionGraph> versions = {graph};
  for (const ModificationStep& recipe : recipes) {
    std::vector<motion::SynchronisedMotion> motions;
    for (const motion::Clip& clip : graph.clips) motions.push_back(in_emotion(clip, recipe));
    versions.push_back(motion::with_motions(graph, motions));
  }
  return versions;
}

[[noreturn]] void refuse_turn(const WalkPath& path, const motion::MissedTurn& missed) {
  const WalkStep& step = path.script.at(missed.segment);
  const std::string what = step.turn_deg ? fmt::format("turn by {:.0f}°", *step.turn_deg)
                                         : std::string("keep to the heading of this step");
  throw UnwalkableStep(missed.segment,
                       fmt::format("the motions of the graph cannot {}: {:.0f}° short", what,
                                   std::abs(missed.degrees)),
                       "add motions that turn this far, raise threshold_m, or omit graph: to use "
                       "the built-in walks");
}

motion::WalkedClip walked_script(const WalkPath& path, const std::vector<ModificationStep>& recipes,
                                 const std::vector<motion::MotionGraph>& versions) {
  constexpr double refused_deg = 10.0;
  std::vector<motion::WalkSegment> segments = segments_of(path, {});
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Mood& mood = i == 0 && path.script[i].mood.empty() ? path.mood : path.script[i].mood;
    segments[i].moods.clear();
    if (!mood.empty()) segments[i].moods = version_shares(mood, recipes);
  }
  motion::GuidedWalk walk = motion::scripted_walk(std::span(versions), segments);
  if (walk.missed && std::abs(walk.missed->degrees) > refused_deg) refuse_turn(path, *walk.missed);
  return {std::move(walk.clip), std::move(walk.plants), std::move(walk.segment_starts)};
}

motion::WalkedClip walked_by_graph(const Stimulus& stimulus) {
  const WalkPath& path = *stimulus.walk;
  const std::vector<ModificationStep>& recipes = stimulus.walk_moods;
  const motion::MotionGraph graph =
      motion::motion_graph(clips_of(path, stimulus.output.fps), {.threshold_m = path.threshold_m});
  const std::vector<motion::MotionGraph> versions = versions_of(graph, recipes);
  if (path.points.empty()) return walked_script(path, recipes, versions);
  std::vector<motion::MoodChange> moods;
  if (!path.mood.empty() || !path.moods.empty())
    moods.push_back({0.0, version_shares(path.mood, recipes)});
  for (const MoodChange& change : path.moods)
    moods.push_back({change.seconds, version_shares(change.mood, recipes)});
  motion::GuidedWalk walk = motion::walk_along(std::span(versions), places_of(path), moods);
  return {std::move(walk.clip), std::move(walk.plants)};
}

/// The built-in walks of a set with what is rated of them; read when it is first needed.
class RatedWalks {
 public:
  explicit RatedWalks(const std::string& set) : set_(set.substr(set.find(':') + 1)) {}

  Mood shares_of(const Mood& adjectives) {
    Stimulus stimulus = plain_stimulus(manifest_);
    stimulus.adjectives = adjectives;
    const ParameterRequest request = request_of(stimulus, repertoire());
    const FittedInterface fitted =
        fit_interface(request.sliders, manifest_.interpolation, repertoire(), request.held);
    const Eigen::VectorXd weights =
        motion::weights_at(fitted.interpolator, request.settings).weights;
    Mood mood;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      if (weights(i) > 0.0)
        mood.emplace_back(repertoire().names[static_cast<std::size_t>(i)].name, weights(i));
    }
    return mood;
  }

 private:
  const Repertoire& repertoire() {
    if (!repertoire_) {
      manifest_.examples.builtin = set_;
      manifest_.ratings.source = Ratings::Source::builtin;
      repertoire_ = load_repertoire(manifest_);
    }
    return *repertoire_;
  }

  std::string set_;
  Manifest manifest_;
  std::optional<Repertoire> repertoire_;
};

}  // namespace

motion::WalkedClip walked(const Stimulus& stimulus) {
  if (!stimulus.walk->graph.empty()) return walked_by_graph(stimulus);
  const WalkPath path = in_walks(*stimulus.walk);
  const Moods moods = moods_of(path);
  const motion::WalkerGaits gaits = gaits_of(path, moods);
  const motion::ScriptedWalkOptions options{.frames_per_second = stimulus.output.fps,
                                            .moods = moods_in_time(path, moods)};
  if (path.points.empty()) return motion::scripted_walk(gaits, segments_of(path, moods), options);
  return motion::walk_along(gaits, places_of(path), path.pace, options);
}

WalkPath in_walks(WalkPath path) {
  RatedWalks rated(path.set);
  const auto turn = [&](Mood& mood) {
    if (is_of_adjectives(path, mood)) mood = rated.shares_of(mood);
  };
  turn(path.mood);
  for (WalkStep& step : path.script) turn(step.mood);
  for (MoodChange& change : path.moods) turn(change.mood);
  return path;
}

}  // namespace mien::pipeline
