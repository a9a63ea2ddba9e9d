#include "pipeline/study/recipes/recipe_table.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

constexpr char recipes[] =
    "recipes:\n"
    "  bowed: {posture: {head-flexion: 20, spine-flexion: 15}}\n"
    "  still: {}\n"
    "  upright: {posture: {head-flexion: -20, spine-flexion: -15}}\n";

/// The results of a study of a built-in walk, with the stimuli in `acted`.
std::vector<RecipeResult> results_of(const std::string& acted, const char* role = "reference") {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "my.recipes.yaml", recipes);
  const ManifestReading reading = parse_manifest(
      "mien: 1\nstudy: s\nrecipes: my.recipes.yaml\nexamples: {set: builtin:walks-10}\nstimuli:\n"
      "- {id: calm, role: " +
          std::string(role) + ", weights: {normal: 1}}\n" + acted,
      folder.path() / "m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty());
  return recipe_results(reading.manifest);
}

const RecipeResult& of(const std::vector<RecipeResult>& results, const char* emotion) {
  for (const RecipeResult& result : results) {
    if (result.emotion == emotion) return result;
  }
  throw std::runtime_error("no such recipe");
}

constexpr char acted_by_the_recipe[] =
    "- {id: a, weights: {normal: 1}, modify: {emotion: bowed}, factors: {neutral: calm, emotion: "
    "bowed}}\n"
    "- {id: b, weights: {normal: 1}, modify: {emotion: bowed}, factors: {neutral: calm, emotion: "
    "still}}\n"
    "- {id: c, weights: {normal: 1}, modify: {emotion: bowed}, factors: {neutral: calm, emotion: "
    "upright}}\n";

TEST(RecipeTable, IsAllRightForAnActorWhoDoesWhatTheRecipeSays) {
  const std::vector<RecipeResult> results = results_of(acted_by_the_recipe);
  const RecipeResult& bowed = of(results, "bowed");
  EXPECT_GE(bowed.changed, 3);
  EXPECT_EQ(bowed.right, bowed.changed);
  EXPECT_EQ(bowed.wrong, 0);
  EXPECT_NEAR(*bowed.modified_distance_m, 0.0, 1e-9);
  EXPECT_GT(*bowed.neutral_distance_m, 0.02);
  EXPECT_TRUE(bowed.is_nearer());
}

TEST(RecipeTable, TellsNoChangeFromAWrongOne) {
  const std::vector<RecipeResult> results = results_of(acted_by_the_recipe);
  const RecipeResult& still = of(results, "still");
  EXPECT_EQ(still.right + still.wrong, 0);
  EXPECT_EQ(*still.neutral_distance_m, *still.modified_distance_m);
  EXPECT_TRUE(still.is_nearer());
  const RecipeResult& upright = of(results, "upright");
  EXPECT_EQ(upright.changed, still.changed);
  EXPECT_GT(upright.wrong, upright.changed / 2);
  EXPECT_GT(*upright.modified_distance_m, *upright.neutral_distance_m);
  EXPECT_FALSE(upright.is_nearer());
}

TEST(RecipeTable, HasEveryRecipeAlsoWithoutAnActedVersion) {
  const std::vector<RecipeResult> results = results_of("");
  ASSERT_EQ(results.size(), 3u);
  for (const RecipeResult& result : results) {
    EXPECT_FALSE(result.is_compared());
    EXPECT_FALSE(result.neutral_distance_m.has_value());
  }
}

TEST(RecipeTable, RefusesWhatItCannotCompare) {
  const auto refused = [](const std::string& acted, const char* role = "reference") {
    try {
      results_of(acted, role);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refused("- {id: a, weights: {sad: 1}, factors: {neutral: clam, emotion: bowed}}\n")
                .find("m.yaml:7:49: \"clam\" is no stimulus with role: reference; did you mean "
                      "\"calm\""),
            std::string::npos);
  EXPECT_NE(refused("- {id: a, weights: {sad: 1}, factors: {neutral: calm, emotion: bowled}}\n")
                .find("there is no recipe for \"bowled\"; did you mean \"bowed\""),
            std::string::npos);
  EXPECT_NE(refused("", "created").find("there is no neutral motion"), std::string::npos);
}

TEST(EmotionSummaries, CountEachMotionOnceAndEachActedVersion) {
  const std::vector<RecipeResult> results = {
      {"s", "calm", "sad", "a", 10, 8, 1, 0.05, 0.04, {"joint-limit LeftKnee"}},
      {"s", "calm", "sad", "b", 10, 5, 5, 0.05, 0.06, {"joint-limit LeftKnee"}},
      {"t", "calm", "sad", "", 0, 0, 0, {}, {}, {}},
      {"t", "calm", "angry", "", 0, 0, 0, {}, {}, {}}};
  const std::vector<EmotionSummary> summaries = emotion_summaries(results);
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_EQ(summaries[0].emotion, "angry");
  EXPECT_EQ(summaries[0].comparisons, 0);
  const EmotionSummary& sad = summaries[1];
  EXPECT_EQ(sad.motions, 2);
  EXPECT_EQ(sad.faulty, 1);
  EXPECT_EQ(sad.comparisons, 2);
  EXPECT_EQ(sad.changed, 20);
  EXPECT_EQ(sad.right, 13);
  EXPECT_EQ(sad.wrong, 6);
  EXPECT_EQ(sad.mostly_right, 1);
  EXPECT_EQ(sad.nearer, 1);
}

}  // namespace
}  // namespace mien::pipeline
