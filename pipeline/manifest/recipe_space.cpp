#include "pipeline/manifest/recipe_space.h"

namespace mien::pipeline {

NamedLimits dimensions_of(const RecipeSpace& recipe) {
  NamedLimits dimensions = recipe.emotions;
  dimensions.insert(dimensions.end(), recipe.posture.begin(), recipe.posture.end());
  const auto add = [&](const char* name, const std::optional<DimensionLimits>& limits) {
    if (limits) dimensions.emplace_back(name, *limits);
  };
  add("paths", recipe.paths);
  add("acceleration", recipe.acceleration);
  add("tempo", recipe.tempo);
  return dimensions;
}

}  // namespace mien::pipeline
