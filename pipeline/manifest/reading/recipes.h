#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// A collection of recipes for emotions.
struct RecipeBook {
  std::string name;
  std::vector<Recipe> recipes;

  /// Returns the recipe for an emotion, or nullptr.
  const Recipe* find(std::string_view emotion) const;
  std::vector<std::string> names() const;
};

/// `recipes:`, a map of names to recipes.
struct RecipesMapForm {
  static void read(const DocumentValue& given, std::vector<Recipe>& recipes);
  static nlohmann::ordered_json write(const std::vector<Recipe>& recipes,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<Recipe>(); }
};

void fields_of(auto&& field, MaybeConst<RecipeBook> auto& book) {
  field("name", book.name, concerns::page);
  field.by("recipes", book.recipes, concerns::motion | concerns::required, RecipesMapForm());
}

/// Returns the text of a built-in recipes file: "builtin" (in the actor's own terms,
/// fitted to acted motions, see motion/README.md), "builtin@0.2" (those of mien 0.2, after the
/// emotion thesis), "builtin@0.3" (those of mien 0.3) or "fig29" (figure 29 of that thesis). Empty
/// for any other name.
std::string_view builtin_recipes_text(std::string_view name);

/// Returns the recipes of "builtin", "builtin@0.2", "builtin@0.3", "fig29" or a file. Throws Faults
/// that list the faults of the file, and Error if it cannot be read. Example of a file:
///
///     name: my emotions
///     recipes:
///       sad: {ja: 悲しい, paths: 0.5, tempo: 0.9, posture: {head-flexion: 25}}
RecipeBook read_recipes(const std::string& source, const std::filesystem::path& file);
RecipeBook parse_recipes(std::string_view yaml, const std::filesystem::path& file);

/// Resolves each modification step of the stimuli: its recipe with the step's own settings applied,
/// and a derived seed; likewise the moods of paths through a motion graph (Stimulus::walk_moods).
/// Returns faults for unknown emotions, for moods whose recipe contains a pose, and the faults of
/// the recipes file.
std::vector<Fault> resolve_modifications(Manifest& manifest);

}  // namespace mien::pipeline
