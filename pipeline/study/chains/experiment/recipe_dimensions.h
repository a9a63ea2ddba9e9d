#pragma once

#include <vector>

#include "motion/live/live_modification.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/recipe_space.h"

namespace mien::pipeline {

/// The modifications of an adaptive experiment in a space of recipes, for the live core. Throws
/// Error if a recipe is not known or has a pose, whose motion pages do not have.
motion::LiveModification live_modification(const Manifest& manifest);

/// The steps of `modify:` that make the motion of a point, which has a value for each of
/// dimensions_of(recipe), rounded to 0.001: each recipe with a strength above 0, then everything
/// else together.
std::vector<ModificationStep> modification_steps(const RecipeSpace& recipe,
                                                 const std::vector<double>& point);

}  // namespace mien::pipeline
