#include "pipeline/manifest/reading/recipes.h"

#include <set>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

ManifestReading parse(const std::string& rest, const std::filesystem::path& folder = "/nowhere") {
  return parse_manifest("mien: 1\nstudy: s\nseed: 7\nexamples: {set: builtin:walks-10}\n" + rest,
                        folder / "m.yaml", [](const std::string&) { return std::nullopt; });
}

std::string told(const ManifestReading& reading) {
  std::string text;
  for (const Fault& fault : reading.faults) text += to_string(fault) + "\n";
  return text;
}

double degrees_of(const motion::Modification& m, motion::PostureUnit unit) {
  for (const motion::PostureChange& change : m.posture) {
    if (change.unit == unit) return change.degrees;
  }
  return 0.0;
}

TEST(Recipes, OfTheThesisAreThoseOfItsFigure) {
  const RecipeBook book = read_recipes("fig29", "");
  EXPECT_EQ(book.names(), (std::vector<std::string>{"afraid", "angry", "confident", "energetic-sad",
                                                    "excited", "feminine", "happy", "masculine",
                                                    "relaxed", "sad", "strong", "tired", "weak"}));
  const ModificationEdit& sad = book.find("sad")->edit;
  EXPECT_EQ(sad.values.paths, 0.5);
  EXPECT_FALSE(sad.names("acceleration"));
  ASSERT_EQ(sad.values.posture.size(), 2u);
  EXPECT_EQ(sad.values.posture[0].unit, motion::PostureUnit::head_flexion);
  EXPECT_EQ(sad.values.posture[0].degrees, 25.0);
  EXPECT_EQ(book.find("relaxed")->edit.values.acceleration, -0.7);
  EXPECT_TRUE(motion::is_identity(with_edit({}, book.find("happy")->edit)));
}

TEST(Recipes, OfOurOwnNameAllOfTheThesisAndAreAllowed) {
  const RecipeBook book = read_recipes("builtin", "");
  for (const std::string& name : read_recipes("fig29", "").names()) {
    EXPECT_NE(book.find(name), nullptr) << name;
  }
  for (const Recipe& recipe : book.recipes) {
    EXPECT_NO_THROW(motion::check(with_edit({}, recipe.edit))) << recipe.name;
    EXPECT_FALSE(recipe.japanese.empty()) << recipe.name;
  }
}

TEST(Recipes, OfFormerVersionsStay) {
  const auto tempo_of_strong = [](const char* recipes) {
    return read_recipes(recipes, "").find("strong")->edit.values.tempo.factor;
  };
  EXPECT_EQ(tempo_of_strong("builtin@0.2"), 1.0);
  EXPECT_EQ(tempo_of_strong("builtin@0.3"), 0.73);
  EXPECT_EQ(read_recipes("builtin@0.3", "").names(), read_recipes("builtin", "").names());
}

TEST(Recipes, NameEveryPostureUnitOfTheProgram) {
  const nlohmann::json& schema = manifest_schema();
  const nlohmann::json& properties =
      schema["definitions"]["modification"]["properties"]["posture"]["properties"];
  std::set<std::string> of_schema, of_program;
  for (const auto& [key, value] : properties.items()) of_schema.insert(key);
  for (const motion::PostureUnitName& unit : motion::posture_units()) {
    of_program.insert(std::string(unit.name));
  }
  EXPECT_EQ(of_schema, of_program);
}

TEST(Recipes, AreOverruledByWhatAStepSays) {
  const ManifestReading reading = parse(
      "recipes: fig29\nstimuli:\n"
      "- {id: a, weights: {normal: 1}, modify: {emotion: sad, strength: 0.5, tempo: 0.9, posture: "
      "{head-flexion: 40}}}\n");
  EXPECT_EQ(told(reading), "");
  const ModificationStep& step = reading.manifest.stimuli[0].modify.at(0);
  EXPECT_EQ(step.strength, 0.5);
  EXPECT_EQ(step.modification.paths, 0.5);
  EXPECT_EQ(step.modification.tempo, 0.9);
  EXPECT_EQ(degrees_of(step.modification, motion::PostureUnit::head_flexion), 40.0);
  EXPECT_EQ(degrees_of(step.modification, motion::PostureUnit::chest_flexion), 6.0);
}

TEST(Recipes, OfAFileTakeThePlaceOfOurs) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "my.recipes.yaml",
             "recipes:\n  bored: {ja: 退屈な, note: slow, tempo: 0.8, limbs: [hands]}\n");
  const std::string stimulus =
      "stimuli:\n- {id: a, weights: {normal: 1}, modify: {emotion: bored}}\n";
  const ManifestReading reading = parse("recipes: my.recipes.yaml\n" + stimulus, folder.path());
  EXPECT_EQ(told(reading), "");
  const motion::Modification& bored = reading.manifest.stimuli[0].modify.at(0).modification;
  EXPECT_EQ(bored.tempo, 0.8);
  EXPECT_FALSE(bored.limbs.head);
  EXPECT_TRUE(bored.limbs.left_hand);
}

TEST(Recipes, OfABrokenFileAreToldWithTheirPlaces) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "my.recipes.yaml",
             "recipes:\n  bored: {temp: 0.8}\n  keen: {paths: long, posture: {head-flexon: 3}}\n");
  const ManifestReading reading =
      parse("recipes: my.recipes.yaml\nstimuli:\n- {id: a, weights: {normal: 1}}\n", folder.path());
  const std::string faults = told(reading);
  EXPECT_NE(faults.find("my.recipes.yaml:2:11: recipes.bored.temp: unknown key; did you mean "
                        "\"tempo\"?"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find("my.recipes.yaml:3:17: recipes.keen.paths: must be a number"),
            std::string::npos)
      << faults;
  EXPECT_NE(faults.find("head-flexon: unknown key; did you mean \"head-flexion\"?"),
            std::string::npos)
      << faults;
}

TEST(Recipes, MayNotGivePathsAndGains) {
  try {
    parse_recipes("recipes:\n  both: {paths: 1.2, gains: {middle: 2}}\n", "/nowhere/r.yaml");
    FAIL() << "nothing was thrown";
  } catch (const Faults& faults) {
    EXPECT_EQ(to_string(faults.list().at(0)),
              "/nowhere/r.yaml:2:29: recipes.both.gains: paths already determines the band gains; "
              "give paths or gains");
  }
}

TEST(Recipes, TellWhereTheirOwnPosesAreMissing) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "r");
  write_file(folder.path() / "r" / "my.recipes.yaml",
             "recipes:\n  slump: {pose: {neutral: no.bvh, posed: somebody}}\n");
  const ManifestReading reading = parse_manifest(
      "mien: 1\nstudy: s\nrecipes: r/my.recipes.yaml\nstimuli:\n"
      "- {id: a, clip: w.bvh, modify: {emotion: slump}}\n",
      folder.path() / "m.yaml", [](const std::string&) { return std::nullopt; });
  const std::string faults = told(reading);
  EXPECT_NE(faults.find("m.yaml:5:42: stimuli[0].modify.emotion: its recipe uses a pose of " +
                        (folder.path() / "r" / "no.bvh").string() + ": there is no such file"),
            std::string::npos)
      << faults;
}

TEST(Recipes, UnknownEmotionsAreRefusedWithTheNearestName) {
  const ManifestReading reading =
      parse("stimuli:\n- {id: a, weights: {normal: 1}, modify: {emotion: angri}}\n");
  EXPECT_NE(told(reading).find(
                "m.yaml:6:51: stimuli[0].modify.emotion: there is no recipe for \"angri\"; did you "
                "mean \"angry\"?"),
            std::string::npos)
      << told(reading);
}

TEST(Recipes, PathsAndGainsExcludeEachOther) {
  const ManifestReading reading = parse(
      "stimuli:\n- {id: a, weights: {normal: 1}, modify: {paths: 1.2, gains: {middle: 2}}}\n");
  EXPECT_NE(told(reading).find("stimuli[0].modify.gains: paths already"), std::string::npos)
      << told(reading);
}

TEST(Recipes, VariationHasASeedOfItsOwnInEveryStimulus) {
  const ManifestReading reading = parse(
      "stimuli:\n- {id: a, weights: {normal: 1}, modify: {variation: 0.5}}\n"
      "- {id: b, weights: {normal: 1}, modify: {variation: 0.5}}\n"
      "- {id: c, weights: {normal: 1}, modify: {variation: 0.5, seed: 3}}\n");
  const auto seed = [&](std::size_t i) {
    return reading.manifest.stimuli[i].modify.at(0).modification.seed;
  };
  EXPECT_NE(seed(0), seed(1));
  EXPECT_EQ(seed(2), 3u);
}

}  // namespace
}  // namespace mien::pipeline
