// Chains in a space of modifications of one motion.

#include <gtest/gtest.h>

#include "motion/live/live_core.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/study/chains/experiment/chain_example.h"
#include "pipeline/study/chains/experiment/chain_results.h"
#include "pipeline/study/chains/experiment/recipe_dimensions.h"
#include "pipeline/study/chains/experiment/simulated_chains.h"
#include "pipeline/study/chains/experiment/word_prototypes.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

constexpr char recipe_chains[] =
    "{participants: 3, method: gibbs, words: [sad, proud], iterations: 4, space: {recipe: {of: "
    "normal, emotions: {sad: [0, 1.5], angry: [0, 1]}, posture: {head-flexion: [-10, 30]}, paths: "
    "[0.5, 1.5], tempo: [0.8, 1.25]}}}";

std::string with_recipe(const std::string& recipe) {
  return "{participants: 3, method: gibbs, words: [sad], space: {recipe: " + recipe + "}}";
}

TEST(RecipeChains, HaveTheDimensionsAndLimitsOfTheManifest) {
  const ChainExample example(recipe_chains);
  const ChainDesign& design = example.study.design;
  EXPECT_EQ(design.dimensions,
            (std::vector<std::string>{"sad", "angry", "head-flexion", "paths", "tempo"}));
  ASSERT_EQ(design.space.size(), 5U);
  EXPECT_EQ(design.space[2].low, -10.0);
  EXPECT_EQ(design.space[2].high, 30.0);
  EXPECT_EQ(design.steps, 20);
  const nlohmann::ordered_json& chains = example.study.experiment.at("chains");
  EXPECT_EQ(chains.at("kind"), "modifications");
  EXPECT_EQ(chains.at("dimensions")[4].at("high"), 1.25);
  // Only what the page needs of the examples is sent.
  EXPECT_EQ(example.study.bundle.examples.examples.size(), 1U);
  for (const ChainSession& session : example.study.sessions)
    for (const auto& [key, start] : session.starts)
      for (std::size_t d = 0; d < start.size(); ++d) {
        EXPECT_GE(start[d], design.space[d].low) << key;
        EXPECT_LE(start[d], design.space[d].high) << key;
      }
}

/// What participants see is what a stimulus with the steps of `modify:` shows, for several points.
TEST(RecipeChains, ShowTheMotionOfTheStimulusWithTheSameSteps) {
  const ChainExample example(recipe_chains);
  const RecipeSpace& recipe = example.manifest.adaptive->space.recipe;
  motion::LiveCore core(example.study.bundle);
  for (const std::vector<double>& point : {std::vector<double>{0, 0, 0, 1, 1},
                                           {1.234, 0, 12, 1, 1},
                                           {0.5, 0.75, -10, 1.4, 1.25},
                                           {0, 1, 30, 0.5, 0.8}}) {
    Manifest manifest = example.manifest;
    manifest.adaptive.reset();
    Stimulus& stimulus = manifest.stimuli.emplace_back(plain_stimulus(manifest));
    stimulus.id = "made";
    stimulus.weights = {{"normal", 1.0}};
    stimulus.modify = modification_steps(recipe, point);
    const ManifestReading again =
        parse_manifest(manifest_yaml(manifest, "/nowhere"), "/nowhere/p.yaml",
                       [](const std::string&) { return std::nullopt; });
    ASSERT_TRUE(again.faults.empty()) << Faults(again.faults).what();
    Motions motions(again.manifest);
    const motion::Clip& expected = motions.of("made").motion.clip;
    const motion::Clip made = core.make({.kind = motion::InterfaceKind::modifications,
                                         .sliders = example.study.design.dimensions,
                                         .values = point})
                                  .motion.clip;
    ASSERT_EQ(made.frame_count(), expected.frame_count());
    EXPECT_EQ(made.frames_per_second, expected.frames_per_second);
    for (int frame = 0; frame < made.frame_count(); frame += 5) {
      const auto at = static_cast<std::size_t>(frame);
      for (std::size_t j = 0; j < made.poses[at].rotations.size(); ++j)
        EXPECT_LT(made.poses[at].rotations[j].angularDistance(expected.poses[at].rotations[j]),
                  1e-6)
            << point[0] << " frame " << frame << " joint " << j;
      EXPECT_LT((made.poses[at].root_position - expected.poses[at].root_position).norm(), 1e-6);
    }
  }
}

TEST(RecipeChains, LeadSimulatedPeopleToPrototypesOfTheRecipe) {
  const ChainExample example(recipe_chains);
  const auto truth = usual_truth(example.study);
  EXPECT_DOUBLE_EQ(truth.at("sad").mean[0], 1.2);
  const test::TemporaryFolder folder;
  write_file(folder.path() / "steps.csv",
             chain_steps_csv(simulated_chains(example.study, false, truth), example.study.design));
  const ChainResults results = chain_results(
      example.study, read_chain_answers({folder.path() / "steps.csv"}, example.study), {});
  EXPECT_TRUE(results.simulated);
  EXPECT_NEAR(results.words[0].prototype()[0], 1.2, 0.2);
  write_file(folder.path() / "words.scales.yaml",
             "name: words\nscales:\n  sad: {low: not sad, high: sad}\n  proud: {low: not proud, "
             "high: proud}\n");
  const Manifest prototypes = prototype_manifest(example.manifest, example.study, results,
                                                 folder.path() / "words.scales.yaml");
  const std::string yaml = manifest_yaml(prototypes, folder.path());
  const ManifestReading again = parse_manifest(yaml, folder.path() / "p.yaml",
                                               [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(again.faults.empty()) << Faults(again.faults).what();
  const Stimulus& sad = again.manifest.stimuli.at(0);
  EXPECT_EQ(sad.weights, (NamedValues{{"normal", 1.0}}));
  ASSERT_EQ(sad.modify.size(), 3U) << yaml;
  EXPECT_EQ(sad.modify[0].emotion, "sad");
  EXPECT_NEAR(sad.modify[0].strength, results.words[0].prototype()[0], 0.0006);
  EXPECT_EQ(sad.modify[1].emotion, "angry");
  EXPECT_NEAR(sad.modify[2].modification.paths, results.words[0].prototype()[3], 0.0006);
  EXPECT_NE(yaml.find("simulated"), std::string::npos);
}

TEST(RecipeChains, AreReadAsTheyAreWritten) {
  const Manifest manifest = chain_manifest(recipe_chains);
  const ManifestReading again =
      parse_manifest(manifest_yaml(manifest, "/nowhere"), "/nowhere/words.yaml",
                     [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(again.faults.empty()) << Faults(again.faults).what();
  EXPECT_EQ(again.manifest.adaptive->space, manifest.adaptive->space);
  EXPECT_EQ(manifest.adaptive->space.recipe.posture.at(0).second, (DimensionLimits{-10.0, 30.0}));
}

TEST(RecipeChains, AreRefusedWithTheReason) {
  struct Wrong {
    const char* recipe;
    const char* place;
    const char* words;
  };
  for (const Wrong& one :
       {Wrong{"{of: normal, emotions: {glad: [0, 1]}}", "adaptive.space.recipe.emotions.glad",
              "there is no recipe for \"glad\""},
        {"{of: nobody, paths: [0.5, 1.5]}", "adaptive.space.recipe.of", "unknown example"},
        {"{of: normal, posture: {head-flexon: [0, 9]}}", "adaptive.space.recipe.posture",
         "did you mean \"head-flexion\""},
        {"{of: normal, posture: {head-flexion: [9, -9]}}",
         "adaptive.space.recipe.posture.head-flexion", "do not ascend"},
        {"{of: normal, tempo: [1, 1]}", "adaptive.space.recipe.tempo", "do not ascend"},
        {"{of: normal, tempo: [1, 9]}", "adaptive.space.recipe.tempo", "4"},
        {"{of: normal}", "words.yaml:6:", "no dimensions"},
        {"{paths: [0.5, 1.5], tempo: [1, 2]}", "adaptive.space.recipe", "of"}}) {
    const std::string told = chain_fault(with_recipe(one.recipe));
    EXPECT_NE(told.find(one.place), std::string::npos) << one.recipe << "\n" << told;
    EXPECT_NE(told.find(one.words), std::string::npos) << one.recipe << "\n" << told;
  }
  EXPECT_NE(chain_fault("{participants: 3, method: gibbs, words: [sad], space: {recipe: {of: "
                        "normal, paths: [0, 1]}, groups: all}}")
                .find("dimensions of several kinds"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
