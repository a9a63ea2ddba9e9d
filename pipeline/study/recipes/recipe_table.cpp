#include "pipeline/study/recipes/recipe_table.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "motion/measures/differences/feature_change.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/production/synthesis/modified_motion.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

namespace {

/// Empty for a motion that is not compared.
template <class Value>
std::optional<Value> of_comparison(const RecipeResult& result, Value value) {
  return result.is_compared() ? std::optional(value) : std::nullopt;
}

constexpr auto results_columns = table_of<RecipeResult>(
    "recipe-results.csv", "recipe, neutral motion and acted version",
    {{"study", "", "study whose manifest names the motions", [](auto& r) { return r.study; }},
     {"neutral", "", "stimulus that the recipe modifies", [](auto& r) { return r.neutral; }},
     {"emotion", "", "name of the recipe", [](auto& r) { return r.emotion; }},
     {"acted", "", "acted stimulus; empty if there is none", [](auto& r) { return r.acted; }},
     {"changed", "",
      "number of motion features in which the acted motion differs measurably from the neutral one",
      [](auto& r) { return of_comparison(r, r.changed); }},
     {"right", "", "of these, changed by the recipe in the same direction, by at least a tenth",
      [](auto& r) { return of_comparison(r, r.right); }},
     {"wrong", "", "of these, changed by the recipe in the opposite direction, by at least a tenth",
      [](auto& r) { return of_comparison(r, r.wrong); }},
     {"right_share", "0–1", "right divided by changed",
      [](auto& r) { return of_comparison(r, r.share_right()); }},
     {"d_neutral_m", "m", "D of the neutral motion from the acted one",
      [](auto& r) { return r.neutral_distance_m; }},
     {"d_modified_m", "m", "D of the modified motion from the acted one",
      [](auto& r) { return r.modified_distance_m; }},
     {"new_errors", "", "number of lint errors of the modified motion that the neutral one lacks",
      [](auto& r) { return r.errors.size(); }},
     {"errors", "", "their checks and joints, separated by semicolons",
      [](auto& r) { return fmt::format("{}", fmt::join(r.errors, "; ")); }}});

constexpr auto summary_columns = table_of<EmotionSummary>(
    "recipe-summary.csv", "emotion",
    {{"emotion", "", "name of the recipe", [](auto& r) { return r.emotion; }},
     {"motions", "", "number of neutral motions that it modifies",
      [](auto& r) { return r.motions; }},
     {"faulty", "", "of these, with lint errors that the neutral motion lacks",
      [](auto& r) { return r.faulty; }},
     {"comparisons", "", "number of acted versions", [](auto& r) { return r.comparisons; }},
     {"changed", "", "features that the actors changed measurably, over all acted versions",
      [](auto& r) { return r.changed; }},
     {"right", "", "of these, changed by the recipe in the same direction",
      [](auto& r) { return r.right; }},
     {"wrong", "", "of these, changed by the recipe in the opposite direction",
      [](auto& r) { return r.wrong; }},
     {"mostly_right", "", "acted versions with at least 75 % of the features right",
      [](auto& r) { return r.mostly_right; }},
     {"nearer", "",
      "acted versions from which the modified motion is no farther (D) than the neutral one",
      [](auto& r) { return r.nearer; }}});

std::string modified_id(const std::string& neutral, const std::string& emotion) {
  return neutral + "+" + emotion;
}

bool is_reference(const Stimulus& stimulus) {
  return stimulus.role == Role::reference && stimulus.people.empty();
}

/// The references of a manifest, each modified by each recipe, in a manifest of its own.
Manifest with_modified_references(const Manifest& manifest, const RecipeBook& book) {
  Manifest result = manifest;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!is_reference(stimulus)) continue;
    for (const Recipe& recipe : book.recipes) {
      Stimulus modified = stimulus;
      modified.id = modified_id(stimulus.id, recipe.name);
      modified.role = Role::created;
      modified.on_fault = OnFault::warn;
      ModificationStep step;
      step.path = member_path(stimulus.path, "modify");
      step.emotion = recipe.name;
      modified.modify.push_back(std::move(step));
      result.stimuli.push_back(std::move(modified));
    }
  }
  if (result.stimuli.size() == manifest.stimuli.size()) {
    throw Error(Place{manifest.file.string(), 0, 0}, "there is no neutral motion",
                "give at least one stimulus the role: reference");
  }
  if (std::vector<Fault> faults = resolve_modifications(result); !faults.empty())
    throw Faults(std::move(faults));
  return result;
}

/// An acted stimulus, and what it is an acted version of.
struct ActedVersion {
  const Stimulus* acted;
  std::string neutral;
  std::string emotion;
};

std::vector<ActedVersion> acted_versions(const Manifest& manifest, const RecipeBook& book) {
  std::vector<ActedVersion> versions;
  std::vector<std::string> references;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (is_reference(stimulus)) references.push_back(stimulus.id);
  }
  for (const Stimulus& stimulus : manifest.stimuli) {
    const std::string neutral = level_of(stimulus, "neutral");
    if (neutral.empty()) continue;
    const std::string path = member_path(stimulus.path, "factors");
    if (std::ranges::find(references, neutral) == references.end()) {
      throw Error(place_of(manifest.places, member_path(path, "neutral")),
                  motion::in_quotes(neutral) + " is no stimulus with role: reference",
                  motion::did_you_mean(neutral, references));
    }
    const std::string emotion = level_of(stimulus, "emotion");
    if (book.find(emotion) == nullptr) {
      throw Error(place_of(manifest.places, member_path(path, "emotion")),
                  "there is no recipe for " + motion::in_quotes(emotion),
                  motion::did_you_mean(emotion, book.names()));
    }
    versions.push_back({&stimulus, neutral, emotion});
  }
  return versions;
}

std::vector<std::string> error_names(const std::vector<motion::Finding>& errors) {
  std::vector<std::string> names;
  for (const motion::Finding& error : errors) {
    std::string name = error.check;
    if (!error.joint.empty()) name += " " + error.joint;
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

void compare(RecipeResult& result, Motions& motions) {
  const std::string modified = modified_id(result.neutral, result.emotion);
  const auto features = [&](const std::string& name) {
    return motion::measure_features(motions.of(name).motion);
  };
  for (const motion::FeatureChange& change : motion::feature_changes(
           features(result.neutral), features(result.acted), features(modified))) {
    result.changed += change.moved() ? 1 : 0;
    result.right += change.agrees() ? 1 : 0;
    result.wrong += change.opposes() ? 1 : 0;
  }
  result.neutral_distance_m = motions.distance(result.acted, result.neutral).mean;
  result.modified_distance_m = motions.distance(result.acted, modified).mean;
}

}  // namespace

double RecipeResult::share_right() const {
  return changed == 0 ? 1.0 : static_cast<double>(right) / changed;
}

bool RecipeResult::is_nearer() const {
  return neutral_distance_m && *modified_distance_m <= *neutral_distance_m;
}

std::vector<RecipeResult> recipe_results(const Manifest& manifest) {
  const RecipeBook book = read_recipes(manifest.recipes.name, manifest.recipes.file);
  const Manifest crossed = with_modified_references(manifest, book);
  const std::vector<ActedVersion> versions = acted_versions(manifest, book);
  Motions motions(crossed);
  std::vector<RecipeResult> results;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!is_reference(stimulus)) continue;
    const motion::Clip& original = motions.of(stimulus.id).motion.clip;
    for (const Recipe& recipe : book.recipes) {
      const Synthesis& made = motions.of(modified_id(stimulus.id, recipe.name));
      RecipeResult result{.study = manifest.study, .neutral = stimulus.id, .emotion = recipe.name};
      result.errors = error_names(new_errors(made.findings, original));
      const std::size_t before = results.size();
      for (const ActedVersion& version : versions) {
        if (version.neutral != stimulus.id || version.emotion != recipe.name) continue;
        results.push_back(result);
        results.back().acted = version.acted->id;
        compare(results.back(), motions);
      }
      if (results.size() == before) results.push_back(result);
    }
  }
  return results;
}

std::vector<EmotionSummary> emotion_summaries(const std::vector<RecipeResult>& results) {
  std::map<std::string, EmotionSummary> summaries;
  std::map<std::string, std::vector<std::string>> counted;
  for (const RecipeResult& result : results) {
    EmotionSummary& summary = summaries[result.emotion];
    summary.emotion = result.emotion;
    const std::string motion = result.study + "/" + result.neutral;
    if (std::vector<std::string>& known = counted[result.emotion];
        std::ranges::find(known, motion) == known.end()) {
      known.push_back(motion);
      ++summary.motions;
      summary.faulty += result.errors.empty() ? 0 : 1;
    }
    if (!result.is_compared()) continue;
    ++summary.comparisons;
    summary.changed += result.changed;
    summary.right += result.right;
    summary.wrong += result.wrong;
    summary.mostly_right += result.share_right() >= wanted_share ? 1 : 0;
    summary.nearer += result.is_nearer() ? 1 : 0;
  }
  std::vector<EmotionSummary> list;
  for (const auto& named : summaries) list.push_back(named.second);
  return list;
}

WrittenTable recipe_results_table(const std::vector<RecipeResult>& results) {
  return results_columns.of(results);
}

WrittenTable emotion_summaries_table(const std::vector<EmotionSummary>& summaries) {
  return summary_columns.of(summaries);
}

}  // namespace mien::pipeline
