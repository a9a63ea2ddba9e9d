#include "pipeline/production/design/close_levels.h"

#include <gtest/gtest.h>

#include "pipeline/production/design/property_values.h"

namespace mien::pipeline {
namespace {

/// A blend of the normal and the happy walk.
Stimulus blend(const std::string& id, double happy, const Factors& factors) {
  Stimulus stimulus;
  stimulus.id = id;
  stimulus.path = "stimuli." + id;
  stimulus.weights = {{"normal", 1.0 - happy}, {"happy", happy}};
  stimulus.factors = factors;
  return stimulus;
}

Manifest study_of(std::vector<Stimulus> stimuli) {
  Manifest manifest;
  manifest.examples.builtin = "walks-10";
  manifest.stimuli = std::move(stimuli);
  return manifest;
}

TEST(CloseLevels, AreThoseWhoseMotionsDifferByLessThanTheThreshold) {
  Manifest manifest =
      study_of({blend("a", 0.0, {{"mood", "none"}}), blend("b", 0.1, {{"mood", "some"}}),
                blend("c", 1.0, {{"mood", "full"}})});
  Motions motions(manifest);
  const double near = motions.distance("a", "b").mean, far = motions.distance("a", "c").mean;
  manifest.design.threshold_m = 0.5 * (near + far);
  std::vector<FactorLevels> found = close_levels(manifest, motions);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].factor, "mood");
  EXPECT_EQ(found[0].compared, 3);
  ASSERT_GE(found[0].close.size(), 1u);
  EXPECT_EQ(found[0].close[0].first, "none");
  EXPECT_EQ(found[0].close[0].second, "some");
  EXPECT_EQ(found[0].close[0].greatest_m, near);
  manifest.design.threshold_m = near;
  EXPECT_TRUE(close_levels(manifest, motions).empty()) << "not below the threshold";
  manifest.design.threshold_m = 1.0;
  EXPECT_EQ(close_levels(manifest, motions)[0].close.size(), 3u);
  manifest.design.alike = {"mood"};
  EXPECT_TRUE(close_levels(manifest, motions).empty());
}

TEST(CloseLevels, CompareStimuliWithTheSameLevelsOfOtherFactors) {
  // The actors are far apart; the moods of an actor are not.
  Manifest manifest = study_of({blend("a", 0.0, {{"actor", "k"}, {"mood", "low"}}),
                                blend("b", 0.1, {{"actor", "k"}, {"mood", "high"}}),
                                blend("c", 1.0, {{"actor", "t"}, {"mood", "low"}}),
                                blend("d", 0.9, {{"actor", "t"}, {"mood", "high"}})});
  Motions motions(manifest);
  manifest.design.threshold_m = 0.5 * motions.distance("a", "c").mean;
  const std::vector<FactorLevels> found = close_levels(manifest, motions);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].factor, "mood");
  EXPECT_EQ(found[0].close[0].pairs, 2);
  // One pair that is far apart suffices.
  manifest.stimuli[3].weights = {{"normal", 1.0}};
  Motions others(manifest);
  EXPECT_TRUE(close_levels(manifest, others).empty());
}

TEST(CloseLevels, AreNotThoseOfAFactorThatLeavesTheMotionAsItIs) {
  Manifest manifest =
      study_of({blend("a", 0.0, {{"display", "stick"}}), blend("b", 0.0, {{"display", "dots"}})});
  manifest.design.threshold_m = 1.0;
  Motions motions(manifest);
  EXPECT_TRUE(close_levels(manifest, motions).empty());
}

TEST(CloseLevels, AreNotSoughtAmongMoreThanAHundredLevels) {
  std::vector<Stimulus> stimuli;
  for (int i = 0; i < 101; ++i)
    stimuli.push_back(blend("s" + std::to_string(i), 0.0, {{"clip", std::to_string(i)}}));
  stimuli[1].weights = {{"happy", 0.01}, {"normal", 0.99}};
  Manifest manifest = study_of(std::move(stimuli));
  Motions motions(manifest);
  EXPECT_TRUE(close_levels(manifest, motions).empty());
  manifest.stimuli.pop_back();
  Motions fewer(manifest);
  EXPECT_FALSE(close_levels(manifest, fewer).empty());
}

TEST(CloseLevels, AreOneWarningForAFactorWithItsClosestPairs) {
  Manifest manifest =
      study_of({blend("a", 0.0, {{"mood", "none"}}), blend("b", 0.1, {{"mood", "some"}}),
                blend("c", 1.0, {{"mood", "full"}})});
  manifest.design.threshold_m = 1.0;
  Motions motions(manifest);
  const std::vector<DesignWarning> warnings =
      close_level_warnings(manifest, close_levels(manifest, motions));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].path, "stimuli.a.factors.mood");
  EXPECT_NE(warnings[0].wrong.find("3 of 3 pairs of levels differ by less than 1 m"),
            std::string::npos)
      << warnings[0].wrong;
  EXPECT_LT(warnings[0].wrong.find("\"none\" and \"some\""), warnings[0].wrong.find("\"full\""));
}

TEST(PlannedProperties, AreThoseOfTheFilm) {
  Manifest manifest = study_of({blend("a", 0.0, {}), blend("b", 0.0, {})});
  manifest.stimuli[0].output.cycles = 3;
  manifest.stimuli[1].output.in_place = true;
  manifest.stimuli[1].look.figure = scenes::MannequinOptions{};
  Motions motions(manifest);
  const std::vector<PropertyValues> values = planned_properties(manifest, motions);
  const auto value = [&](std::size_t stimulus, std::string_view id) {
    std::size_t i = 0;
    while (stimulus_properties[i].id != id) ++i;
    return values[stimulus][i];
  };
  const motion::Clip& walk = motions.of("a").motion.clip;
  EXPECT_NEAR(value(0, "duration").number, 3.0 * walk.duration_seconds(), 0.05);
  EXPECT_NEAR(value(0, "speed").number, walk.cycle_displacement.norm() / walk.duration_seconds(),
              1e-9);
  EXPECT_NEAR(value(0, "distance").number, 3.0 * walk.cycle_displacement.norm(), 0.1);
  EXPECT_EQ(value(1, "distance").number, 0.0);
  EXPECT_EQ(value(1, "speed").number, value(0, "speed").number);
  EXPECT_EQ(value(0, "figure").text, "stick");
  EXPECT_EQ(value(1, "figure").text, "mannequin");
  EXPECT_EQ(value(1, "in_place").text, "yes");
  EXPECT_EQ(value(0, "sound").text, "without");
  EXPECT_GT(value(0, "figure_height").number, 50.0);
  EXPECT_TRUE(std::isnan(value(0, "luminance").number));
  manifest.equalize.duration = true;
  const std::vector<PropertyValues> equalized = planned_properties(manifest, motions);
  for (std::size_t i = 0; i < std::size(stimulus_properties); ++i) {
    if (std::string_view(stimulus_properties[i].id) == "duration") {
      EXPECT_TRUE(std::isnan(equalized[0][i].number));
    }
  }
}

TEST(PlannedProperties, NameTheSoundFile) {
  Manifest manifest = study_of({blend("a", 0.0, {}), blend("b", 0.0, {}), blend("c", 0.0, {})});
  manifest.stimuli[0].sound = StimulusSound{.file = "/nowhere/sad/speech.wav"};
  manifest.stimuli[1].sound = StimulusSound{.file = "/nowhere/happy/speech.wav", .offset = 1.5};
  manifest.stimuli[2].sound = StimulusSound{.file = "/nowhere/happy/steps.wav"};
  Motions motions(manifest);
  const std::vector<PropertyValues> values = planned_properties(manifest, motions);
  std::vector<std::string> sounds;
  for (const PropertyValues& one : values)
    for (std::size_t i = 0; i < one.size(); ++i)
      if (std::string_view(stimulus_properties[i].id) == "sound") sounds.push_back(one[i].text);
  EXPECT_EQ(sounds, (std::vector<std::string>{"sad/speech.wav", "happy/speech.wav from 1.5 s",
                                              "steps.wav"}));
}

}  // namespace
}  // namespace mien::pipeline
