#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// What emotions are made of.
struct RecipeBook {
  std::string name;
  std::vector<Recipe> recipes;

  /// Nullptr without one of that name.
  const Recipe* find(std::string_view emotion) const;
  std::vector<std::string> names() const;
};

/// `recipes:` by their names.
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

/// The recipes that come with the program, as the text of their file: "builtin" (our own, after
/// what the emotion thesis concluded) and "fig29" (its figure 29). Empty for another name.
std::string_view builtin_recipes_text(std::string_view name);

/// "builtin", "fig29", or what a file holds. Throws Faults that list everything wrong with it:
///
///     name: my emotions
///     recipes:
///       sad: {ja: 悲しい, paths: 0.5, tempo: 0.9, posture: {head-flexion: 25}}
RecipeBook read_recipes(const std::string& source, const std::filesystem::path& file);
RecipeBook parse_recipes(std::string_view yaml, const std::filesystem::path& file);

/// Works out what each step of the stimuli's modifications does: its recipe, with what the step
/// says over it, and a seed of its own. Faults: unknown emotions, and all of the file of recipes.
std::vector<Fault> resolve_modifications(Manifest& manifest);

}  // namespace mien::pipeline
