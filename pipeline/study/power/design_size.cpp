#include "pipeline/study/power/design_size.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

namespace {

/// Indices into Manifest::stimuli of the rated stimuli of each cell, by its levels.
std::map<std::vector<std::string>, std::vector<std::size_t>> stimuli_by_cell(
    const Manifest& manifest) {
  std::map<std::vector<std::string>, std::vector<std::size_t>> cells;
  const FactorTable table = design_table(manifest);
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (!table.rows[i].empty() && std::ranges::find(table.rows[i], "") == table.rows[i].end())
      cells[table.rows[i]].push_back(i);
  return cells;
}

/// The number-th copy of a stimulus.
Stimulus copy_of(const Stimulus& stimulus, std::size_t number,
                 const std::vector<std::string>& analysed) {
  Stimulus copy = stimulus;
  copy.id += fmt::format("~{}", number);
  for (auto& [factor, level] : copy.factors)
    if (std::ranges::find(analysed, factor) == analysed.end()) level += fmt::format("~{}", number);
  // Levels that follow from how a stimulus is made and named, such as whether its sound is its own.
  for (const std::string& factor : analysed)
    if (std::ranges::find(copy.factors, factor, &Factors::value_type::first) == copy.factors.end())
      copy.factors.emplace_back(factor, level_of(stimulus, factor));
  return copy;
}

}  // namespace

int stimuli_per_cell(const Manifest& manifest) {
  std::size_t count = 0;
  for (const auto& [levels, stimuli] : stimuli_by_cell(manifest)) {
    if (count != 0 && stimuli.size() != count) return 0;
    count = stimuli.size();
  }
  return static_cast<int>(count);
}

Manifest with_stimuli_per_cell(const Manifest& manifest, int count) {
  const Questionnaire& asked = questionnaire_of(manifest);
  if (!asked.pairs.empty())
    throw Error(
        "the questionnaire lists its pairs, so that the number of stimuli cannot be varied",
        "leave the numbers of stimuli out, or state preference: {alike: …} instead of pairs");
  if (!asked.grid.sets.empty())
    throw Error("the questionnaire lists its sets, so that the number of stimuli cannot be varied",
                "leave the numbers of stimuli out, or state grid: {alike: …} instead of sets");
  const std::vector<std::string> factors = design_factors(manifest);
  const auto wanted = static_cast<std::size_t>(count);
  std::vector<std::string> ids = questionnaire_stimuli(manifest);
  Manifest scaled = manifest;
  for (const auto& [levels, stimuli] : stimuli_by_cell(manifest)) {
    for (std::size_t i = wanted; i < stimuli.size(); ++i)
      std::erase(ids, manifest.stimuli[stimuli[i]].id);
    for (std::size_t i = stimuli.size(); i < wanted; ++i) {
      scaled.stimuli.push_back(
          copy_of(manifest.stimuli[stimuli[i % stimuli.size()]], i / stimuli.size() + 1, factors));
      ids.push_back(scaled.stimuli.back().id);
    }
  }
  scaled.questionnaire->stimuli = {.ids = ids, .levels = {}};
  for (const GridSet& set : grid_sets(scaled))
    if (set.stimuli.size() > most_grid_stimuli)
      throw Error(fmt::format("with {} per cell, a trial would have {} stimuli, but at most {} are "
                              "compared in a grid",
                              counted_noun(wanted, "stimulus", "stimuli"), set.stimuli.size(),
                              most_grid_stimuli),
                  "leave larger numbers of stimuli out");
  return scaled;
}

}  // namespace mien::pipeline
