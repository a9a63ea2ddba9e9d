#include "pipeline/manifest/reading/recipes.h"

#include <algorithm>
#include <set>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/derived_seed.h"
#include "pipeline/manifest/people.h"

#include "embedded/emotions_0_2_recipes.h"
#include "embedded/emotions_0_3_recipes.h"
#include "embedded/emotions_recipes.h"
#include "embedded/fig29_recipes.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

RecipeBook build(const JsonReading& reading, const fs::path& folder) {
  const ReadingContext context{
      reading.places, [&](const std::string& path) { return (folder / path).lexically_normal(); }};
  RecipeBook book;
  read({reading.document, "", context}, book);
  return book;
}

std::vector<Fault> faults_of(const RecipeBook& book, const Places& places) {
  std::vector<Fault> faults;
  for (const Recipe& recipe : book.recipes) {
    const std::string path = member_path("recipes", recipe.name);
    if (recipe.name.empty()) {
      faults.push_back({place_of(places, "recipes"), "recipes", "a recipe has no name",
                        "name it as the emotion used in manifests"});
    }
    if (const motion::TempoFault fault = motion::fault_of(recipe.edit.values.tempo);
        !fault.wrong.empty()) {
      const std::string where = path_of(fault, member_path(path, "tempo"));
      faults.push_back({place_of(places, where), where, fault.wrong, fault.remedy});
    }
    if (recipe.edit.names("paths") && recipe.edit.names("gains")) {
      faults.push_back({place_of(places, member_path(path, "gains")), member_path(path, "gains"),
                        "paths already determines the band gains", "give paths or gains"});
    }
  }
  return faults;
}

void resolve(ModificationStep& step, const Recipe* recipe, std::uint64_t study_seed,
             const std::string& stimulus) {
  step.modification.seed =
      derived_seed(study_seed, "variation of " + stimulus + " by " + step.path);
  if (recipe != nullptr) {
    step.modification = with_edit(step.modification, recipe->edit);
    step.pose = recipe->edit.pose;
  }
  step.modification = with_edit(step.modification, step.edit);
  if (step.edit.pose) step.pose = step.edit.pose;
}

/// The recipes that a graph's moods name, each once.
void resolve_moods(Stimulus& stimulus, const RecipeBook& book, const Manifest& manifest,
                   std::vector<Fault>& faults) {
  std::set<std::string> names;
  for (const auto& [below, mood] : places_of_moods(*stimulus.walk)) {
    for (const auto& one : mood) {
      const std::string& name = one.first;
      const std::string path =
          stimulus.path + ".path" + (below.starts_with("[") ? "" : ".") + below + "." + name;
      const Recipe* recipe = book.find(name);
      if (recipe == nullptr) {
        faults.push_back({key_place_of(manifest.places, path), path,
                          "there is no recipe for " + motion::in_quotes(name),
                          motion::did_you_mean(name, book.names())});
      } else if (recipe->edit.pose) {
        faults.push_back({key_place_of(manifest.places, path), path,
                          "its recipe contains a pose, which cannot be held while walking",
                          "use another mood, or apply this one to the stimulus with modify:"});
      } else {
        names.insert(name);
      }
    }
  }
  for (const std::string& name : names) {
    ModificationStep step;
    step.path = stimulus.path + ".path." + name;
    step.emotion = name;
    resolve(step, book.find(name), manifest.seed, stimulus.id);
    stimulus.walk_moods.push_back(std::move(step));
  }
}

}  // namespace

void RecipesMapForm::read(const DocumentValue& given, std::vector<Recipe>& recipes) {
  std::vector<std::pair<std::string, Recipe>> named;
  pipeline::read(given, named);
  for (auto& [name, recipe] : named) {
    recipe.name = name;
    recipes.push_back(std::move(recipe));
  }
}

nlohmann::ordered_json RecipesMapForm::write(const std::vector<Recipe>& recipes,
                                             const WritingOptions& how) {
  OrderedJson map = OrderedJson::object();
  for (const Recipe& recipe : recipes) map[recipe.name] = written(recipe, how);
  return map;
}

namespace {

bool needs_recipes(const Stimulus& stimulus) {
  return !stimulus.modify.empty() || (stimulus.walk && !stimulus.walk->graph.empty());
}

}  // namespace

const Recipe* RecipeBook::find(std::string_view emotion) const {
  const auto found = std::ranges::find(recipes, emotion, &Recipe::name);
  return found == recipes.end() ? nullptr : &*found;
}

std::vector<std::string> RecipeBook::names() const {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) names.push_back(recipe.name);
  return names;
}

std::string_view builtin_recipes_text(std::string_view name) {
  if (name == "builtin") return embedded_emotions_recipes;
  if (name == "builtin@0.2") return embedded_emotions_0_2_recipes;
  if (name == "builtin@0.3") return embedded_emotions_0_3_recipes;
  if (name == "fig29") return embedded_fig29_recipes;
  return {};
}

RecipeBook read_recipes(const std::string& source, const fs::path& file) {
  if (const std::string_view text = builtin_recipes_text(source); !text.empty()) {
    return parse_recipes(text, source + " recipes");
  }
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_document_bytes);
  if (reading.bytes) return parse_recipes(*reading.bytes, file);
  throw Error(Place{file.string(), 0, 0}, reading.error,
              "name a file of recipes (YAML), builtin, builtin@0.2, builtin@0.3 or fig29");
}

RecipeBook parse_recipes(std::string_view yaml, const fs::path& file) {
  const JsonReading reading = read_valid_json(yaml, file.string(), recipes_schema());
  RecipeBook book = build(reading, file.parent_path());
  std::vector<Fault> faults = faults_of(book, reading.places);
  if (!faults.empty()) throw Faults(faults);
  return book;
}

std::vector<Fault> resolve_modifications(Manifest& manifest) {
  // Those that come with mien have no faults, and reading them takes a while.
  const auto is_modified = [](const Stimulus* stimulus) { return needs_recipes(*stimulus); };
  if (manifest.recipes.file.empty() && std::ranges::none_of(motion_sources(manifest), is_modified))
    return {};
  RecipeBook book;
  try {
    book = read_recipes(manifest.recipes.name, manifest.recipes.file);
  } catch (const Faults& faults) {
    return faults.list();
  } catch (const Error& error) {
    return {{place_of(manifest.places, "recipes"), "recipes", error.what(), ""}};
  }
  std::vector<Fault> faults;
  visit_motion_sources(manifest, [&](Stimulus& stimulus) {
    for (ModificationStep& step : stimulus.modify) {
      const Recipe* recipe = book.find(step.emotion);
      if (recipe == nullptr && !step.emotion.empty()) {
        const std::string path = member_path(step.path, "emotion");
        faults.push_back({place_of(manifest.places, path), path,
                          "there is no recipe for " + motion::in_quotes(step.emotion),
                          motion::did_you_mean(step.emotion, book.names())});
      }
      resolve(step, recipe, manifest.seed, stimulus.id);
    }
    if (stimulus.walk && !stimulus.walk->graph.empty())
      resolve_moods(stimulus, book, manifest, faults);
  });
  return faults;
}

}  // namespace mien::pipeline
