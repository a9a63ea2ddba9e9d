#include "pipeline/study/studio/studio_words.h"

#include <string>

#include "motion/modify/posture.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/look/set_file.h"
#include "pipeline/manifest/reading/recipes.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// The built-in sets of examples, as the schema lists them.
ordered_json example_sets() {
  const auto set = nlohmann::json::json_pointer("/properties/examples/properties/set/oneOf");
  ordered_json sets = ordered_json::array();
  const nlohmann::json& schema = manifest_schema();
  for (const auto& branch : schema.at(set)) {
    if (!branch.contains("enum")) continue;
    for (const auto& name : branch["enum"]) sets.push_back(name.get<std::string>());
  }
  return sets;
}

ordered_json recipes_of(const ManifestFile& file) {
  const ManifestState state = file.state();
  const ManifestReading reading = parse_manifest(state.text, file.file(), file.environment());
  const RecipesSource& source = reading.manifest.recipes;
  ordered_json recipes = ordered_json::array();
  for (const Recipe& recipe : read_recipes(source.name, source.file).recipes)
    recipes.push_back({{"name", recipe.name}, {"ja", recipe.japanese}, {"note", recipe.note}});
  return recipes;
}

ordered_json posture() {
  ordered_json units = ordered_json::array();
  for (const motion::PostureUnitName& unit : motion::posture_units())
    units.push_back({{"name", unit.name}, {"note", unit.description}});
  return units;
}

/// All that a step of a modification may say, as the schema has it.
ordered_json modification() {
  return ordered_json::parse(manifest_schema_text())
      .at("definitions")
      .at("modification")
      .at("properties");
}

}  // namespace

ordered_json studio_words(const ManifestFile& file) {
  return {{"sets", example_sets()},
          {"recipes", recipes_of(file)},
          {"posture", posture()},
          {"modification", modification()},
          {"scenes", set_names()},
          {"cameras", {"three-quarter", "front", "side", "follow", "orbit"}},
          {"figures", scenes::figure_names<scenes::Figure>()},
          {"bodies", scenes::figure_names<scenes::BodyFigure>()}};
}

}  // namespace mien::pipeline
