#include "pipeline/study/chains/experiment/recipe_dimensions.h"

#include <cmath>

#include <fmt/format.h>

#include "motion/modify/posture.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/reading/recipes.h"

namespace mien::pipeline {

namespace {

using motion::ModificationDimension;
using motion::ModificationValue;

ModificationDimension dimension_of(const std::string& name, ModificationValue value,
                                   const DimensionLimits& limits) {
  return {.name = name, .value = value, .low = limits[0], .high = limits[1]};
}

/// The modification of a recipe at a strength of 1.
motion::Modification recipe_at_one(const RecipeBook& book, const std::string& name,
                                   std::uint64_t seed) {
  const Recipe* recipe = book.find(name);
  if (recipe == nullptr || recipe->edit.pose)
    throw Error(fmt::format("there is no recipe without a pose for \"{}\"", name),
                "name a recipe of the manifest in adaptive.space");
  motion::Modification modification;
  modification.seed = seed;
  return with_edit(modification, recipe->edit);
}

double rounded_value(double value) { return std::round(1000.0 * value) / 1000.0; }

}  // namespace

motion::LiveModification live_modification(const Manifest& manifest) {
  const RecipeSpace& recipe = adaptive_of(manifest).space.recipe;
  motion::LiveModification by{.original = recipe.of};
  if (!recipe.emotions.empty()) {
    const RecipeBook book = read_recipes(manifest.recipes.name, manifest.recipes.file);
    for (const auto& [name, limits] : recipe.emotions) {
      by.dimensions.push_back(dimension_of(name, ModificationValue::strength, limits));
      by.dimensions.back().recipe = recipe_at_one(book, name, manifest.seed);
    }
  }
  for (const auto& [name, limits] : recipe.posture) {
    by.dimensions.push_back(dimension_of(name, ModificationValue::rotation, limits));
    by.dimensions.back().unit = motion::posture_unit(name).value();
  }
  const auto add = [&](const char* name, ModificationValue value,
                       const std::optional<DimensionLimits>& limits) {
    if (limits) by.dimensions.push_back(dimension_of(name, value, *limits));
  };
  add("paths", ModificationValue::paths, recipe.paths);
  add("acceleration", ModificationValue::acceleration, recipe.acceleration);
  add("tempo", ModificationValue::tempo, recipe.tempo);
  return by;
}

std::vector<ModificationStep> modification_steps(const RecipeSpace& recipe,
                                                 const std::vector<double>& point) {
  std::vector<ModificationStep> steps;
  std::size_t next = 0;
  const auto value = [&] { return rounded_value(point.at(next++)); };
  for (const auto& [name, limits] : recipe.emotions)
    if (const double strength = value(); strength > 0.0)
      steps.push_back({.emotion = name, .strength = strength});
  ModificationEdit others;
  for (const auto& [name, limits] : recipe.posture) {
    others.values.posture.push_back({motion::posture_unit(name).value(), value()});
    others.named.insert("posture");
  }
  const auto take = [&](const char* name, const std::optional<DimensionLimits>& limits,
                        auto& target) {
    if (!limits) return;
    target = value();
    others.named.insert(name);
  };
  take("paths", recipe.paths, others.values.paths);
  take("acceleration", recipe.acceleration, others.values.acceleration);
  take("tempo", recipe.tempo, others.values.tempo);
  if (!others.named.empty()) steps.push_back({.edit = others});
  return steps;
}

}  // namespace mien::pipeline
