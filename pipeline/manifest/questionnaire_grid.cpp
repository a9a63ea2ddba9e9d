#include "pipeline/manifest/questionnaire_grid.h"

#include <algorithm>
#include <map>

#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

using Names = std::vector<std::string>;

GridSet grid_set(const Manifest& manifest, const Names& stimuli) {
  const GridSettings& grid = questionnaire_of(manifest).grid;
  GridSet set{.stimuli = stimuli};
  const Names references = chosen_among(manifest, stimuli, grid.reference);
  const Names anchors = chosen_among(manifest, stimuli, grid.anchor);
  // The checks report sets that have several.
  if (!references.empty()) set.reference = references.front();
  if (!anchors.empty()) set.anchor = anchors.front();
  return set;
}

/// The stimuli by their levels of the factors of `alike`.
std::vector<Names> alike_stimuli(const Manifest& manifest, const Names& stimuli) {
  std::map<Names, std::size_t> places;
  std::vector<Names> sets;
  for (const std::string& id : stimuli) {
    Names levels;
    for (const std::string& factor : questionnaire_of(manifest).grid.alike)
      levels.push_back(level_of(manifest, id, factor));
    const auto [place, is_new] = places.emplace(levels, sets.size());
    if (is_new) sets.emplace_back();
    sets[place->second].push_back(id);
  }
  return sets;
}

std::vector<GridSet> with_roles(const Manifest& manifest, const std::vector<Names>& sets) {
  std::vector<GridSet> all;
  for (const Names& stimuli : sets) all.push_back(grid_set(manifest, stimuli));
  return all;
}

}  // namespace

std::vector<GridSet> grid_sets(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  if (!asked.trials->is_grid) return {};
  if (!asked.grid.sets.empty()) return with_roles(manifest, asked.grid.sets);
  return with_roles(manifest, alike_stimuli(manifest, questionnaire_stimuli(manifest)));
}

std::vector<GridSet> practice_grid_sets(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  if (!asked.trials->is_grid || asked.practice.empty()) return {};
  if (!asked.grid.sets.empty()) return with_roles(manifest, {asked.practice});
  return with_roles(manifest, alike_stimuli(manifest, asked.practice));
}

bool is_stated(const StimulusChoice& choice) {
  return !choice.ids.empty() || !choice.levels.empty();
}

Names chosen_among(const Manifest& manifest, const Names& stimuli, const StimulusChoice& choice) {
  Names chosen;
  if (!is_stated(choice)) return chosen;
  for (const std::string& id : stimuli) {
    const auto found = std::ranges::find(manifest.stimuli, id, &Stimulus::id);
    if (found != manifest.stimuli.end() && is_chosen(*found, choice)) chosen.push_back(id);
  }
  return chosen;
}

}  // namespace mien::pipeline
