#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// The least and the greatest value of a dimension.
using DimensionLimits = std::array<double, 2>;
using NamedLimits = std::vector<std::pair<std::string, DimensionLimits>>;

/// A space of modifications of one motion. Each member that is given is a dimension, or one for
/// each name; their order is that of the members.
struct RecipeSpace {
  std::string of;        ///< the motion that is modified: the name of an example
  NamedLimits emotions;  ///< recipe → limits of its strength
  NamedLimits posture;   ///< rotation (motion::posture_units) → limits, degrees
  std::optional<DimensionLimits> paths, acceleration, tempo;  ///< as in `modify:`

  friend bool operator==(const RecipeSpace&, const RecipeSpace&) = default;
};

void fields_of(auto&& field, MaybeConst<RecipeSpace> auto& recipe) {
  field("of", recipe.of, concerns::required);
  field("emotions", recipe.emotions, concerns::nothing);
  field("posture", recipe.posture, concerns::nothing);
  field("paths", recipe.paths, concerns::nothing);
  field("acceleration", recipe.acceleration, concerns::nothing);
  field("tempo", recipe.tempo, concerns::nothing);
}

/// The dimensions by name, in their order: emotions and rotations as they are named, then "paths",
/// "acceleration" and "tempo".
NamedLimits dimensions_of(const RecipeSpace& recipe);

}  // namespace mien::pipeline
