// Stimuli for each level of a number.

#include "pipeline/manifest/reading/levelled_document.h"

#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/factors.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/manifest/stimulus_level.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

constexpr char beginning[] = "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n";

ManifestReading reading_of(const std::string& stimuli) {
  return parse_manifest(beginning + stimuli, "/nowhere/m.yaml",
                        [](const std::string&) { return std::nullopt; });
}

Manifest manifest_of(const std::string& stimuli) {
  ManifestReading reading = reading_of(stimuli);
  if (!reading.faults.empty()) throw Faults(reading.faults);
  return reading.manifest;
}

/// What is wrong with the manifest, as it is printed.
std::string wrong_with(const std::string& stimuli) {
  const ManifestReading reading = reading_of(stimuli);
  return reading.faults.empty() ? "" : Faults(reading.faults).what();
}

std::vector<std::string> ids_of(const Manifest& manifest) {
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli) ids.push_back(stimulus.id);
  return ids;
}

std::vector<std::string> texts_of(const char* values) {
  std::vector<std::string> texts;
  for (const double value : level_values(json::parse(values))) texts.push_back(shortest(value));
  return texts;
}

using Texts = std::vector<std::string>;

TEST(LevelValues, AreExactDecimals) {
  EXPECT_EQ(texts_of(R"({"from": 0, "to": 1, "steps": 11})"),
            (Texts{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"}));
  EXPECT_EQ(texts_of(R"({"from": 0, "to": 1, "steps": 4})"), (Texts{"0", "0.3333", "0.6667", "1"}));
  EXPECT_EQ(texts_of(R"({"from": 0, "to": 1, "steps": 17})")[1], "0.0625");
  EXPECT_EQ(texts_of(R"({"from": 0.12345, "to": 1.12345, "steps": 3})"),
            (Texts{"0.12345", "0.62345", "1.12345"}));
  EXPECT_EQ(texts_of(R"({"from": 30, "to": -10, "steps": 5})"),
            (Texts{"30", "20", "10", "0", "-10"}));
}

TEST(LevelValues, OfEqualRatiosHaveThem) {
  EXPECT_EQ(texts_of(R"({"from": 10, "to": 320, "steps": 6, "spacing": "log"})"),
            (Texts{"10", "20", "40", "80", "160", "320"}));
  const std::vector<double> values =
      level_values(json::parse(R"({"from": 0.1, "to": 10, "steps": 9, "spacing": "log"})"));
  ASSERT_EQ(values.size(), 9U);
  for (std::size_t i = 1; i < values.size(); ++i)
    EXPECT_NEAR(values[i] / values[i - 1], std::pow(100.0, 1.0 / 8.0), 1e-3) << i;
  EXPECT_EQ(values.front(), 0.1);
  EXPECT_EQ(values[4], 1.0);
  EXPECT_EQ(values.back(), 10.0);
}

TEST(LevelValues, AreWholeOnRequest) {
  EXPECT_EQ(texts_of(R"({"from": 1, "to": 100, "steps": 5, "spacing": "log", "whole": true})"),
            (Texts{"1", "3", "10", "32", "100"}));
}

/// Ranges at random: the ends are as given, neighbours differ by the same to four digits, and no
/// name is longer than its digits demand.
TEST(LevelValues, OfRandomRangesAreEven) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const double from = std::round(static_cast<double>(random() % 2000) - 1000.0) / 100.0;
    const double to =
        std::round(100.0 * from + 10.0 * static_cast<double>(1 + random() % 1000)) / 100.0;
    const int steps = static_cast<int>(2 + random() % 99);
    const json range = {{"from", from}, {"to", to}, {"steps", steps}};
    const std::vector<double> values = level_values(range);
    ASSERT_EQ(values.size(), static_cast<std::size_t>(steps));
    EXPECT_EQ(values.front(), from);
    EXPECT_EQ(values.back(), to);
    const double step = (to - from) / (steps - 1);
    for (std::size_t i = 1; i < values.size(); ++i) {
      EXPECT_NEAR(values[i] - values[i - 1], step, 1.01e-3 * step) << range;
      EXPECT_LE(shortest(values[i]).size(), 12U) << range;
    }
  }
}

TEST(LevelValues, RefuseRangesThatHaveNone) {
  const auto wrong = [](const char* values) {
    try {
      level_values(json::parse(values));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(wrong(R"({"from": 1, "to": 1, "steps": 3})").find("the ends are equal"),
            std::string::npos);
  EXPECT_NE(wrong(R"({"from": 0, "to": 1, "steps": 3, "spacing": "log"})").find("above 0"),
            std::string::npos);
  EXPECT_NE(wrong(R"({"from": 0, "to": 3, "steps": 9, "whole": true})").find("occurs twice"),
            std::string::npos);
  EXPECT_NE(wrong(R"({"from": 0.5, "to": 3, "steps": 3, "whole": true})").find("not whole numbers"),
            std::string::npos);
  EXPECT_NE(wrong("[0.1, 0.3, 0.1]").find("the level 0.1 occurs twice"), std::string::npos);
}

TEST(StimulusLevels, AreStimuliAsIfTheyWereListed) {
  const std::string levels =
      "  - {id: neutral, weights: {normal: 1}}\n"
      "  - {id: sad, factors: {actor: a}, weights: {normal: 1}, modify: {emotion: sad}, levels: "
      "{factor: dose, of: modify.strength, values: {from: 0.1, to: 0.3, steps: 3}}}\n"
      "  - {id: last, weights: {sad: 1}}\n";
  std::string listed = "  - {id: neutral, weights: {normal: 1}}\n";
  for (const char* level : {"0.1", "0.2", "0.3"})
    listed += fmt::format(
        "  - {{id: sad-{0}, factors: {{actor: a, dose: {0}}}, weights: {{normal: 1}}, modify: "
        "{{emotion: sad, strength: {0}}}}}\n",
        level);
  listed += "  - {id: last, weights: {sad: 1}}\n";
  const Manifest made = manifest_of(levels);
  EXPECT_EQ(ids_of(made), (Texts{"neutral", "sad-0.1", "sad-0.2", "sad-0.3", "last"}));
  EXPECT_EQ(manifest_yaml(made, "/nowhere"), manifest_yaml(manifest_of(listed), "/nowhere"));
  EXPECT_EQ(made.origins, (std::vector<std::size_t>{0, 1, 1, 1, 2}));
  EXPECT_EQ(level_of(made.stimuli[2], "dose"), "0.2");
  EXPECT_EQ(levels_made(made), Texts{"sad: 3 levels of dose (modify.strength): 0.1, 0.2, 0.3"});
  // Random numbers of a modification depend on the place and the id.
  const std::uint64_t seed = made.stimuli[2].modify.at(0).modification.seed;
  EXPECT_EQ(seed, manifest_of(listed).stimuli[2].modify.at(0).modification.seed);
  EXPECT_NE(seed, made.stimuli[3].modify.at(0).modification.seed);
}

TEST(StimulusLevels, OfAWeightLeaveTheRestToTheOtherExamples) {
  const Manifest made = manifest_of(
      "  - {id: a, weights: {normal: 3, proud: 1}, levels: {factor: w, of: weights.sad, values: "
      "[0, 0.2, 1]}}\n");
  ASSERT_EQ(made.stimuli.size(), 3U);
  for (const auto& [i, sad] : {std::pair(0, 0.0), std::pair(1, 0.2), std::pair(2, 1.0)}) {
    double sum = 0.0;
    std::map<std::string, double> weights;
    for (const auto& [name, weight] : made.stimuli[static_cast<std::size_t>(i)].weights) {
      weights[name] = weight;
      sum += weight;
    }
    EXPECT_DOUBLE_EQ(sum, 1.0);
    EXPECT_DOUBLE_EQ(weights["sad"], sad);
    EXPECT_DOUBLE_EQ(weights["normal"], 3.0 * weights["proud"]);
  }
}

TEST(StimulusLevels, OfALookKeepTheRestOfIt) {
  const ManifestReading reading = parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {camera: side}\n"
      "stimuli: [{id: a, weights: {sad: 1}, look: {figure: {point-light: {inverted: true}}}, "
      "levels: {factor: dots, of: look.figure.point-light.noise, values: {from: 0, to: 40, steps: "
      "3}}}]\n",
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  ASSERT_EQ(reading.manifest.stimuli.size(), 3U);
  const scenes::PointLightOptions* dots = scenes::dots_in(reading.manifest.stimuli[1].look.figure);
  ASSERT_NE(dots, nullptr);
  EXPECT_EQ(dots->noise, 20);
  EXPECT_TRUE(dots->inverted);
}

TEST(StimulusLevels, OfOneOfSeveralStepsAreItsOwn) {
  const Manifest made = manifest_of(
      "  - {id: a, weights: {normal: 1}, modify: [{emotion: sad}, {paths: 1.2}], levels: {factor: "
      "t, of: 'modify[1].tempo', values: [0.8, 1.25]}}\n");
  ASSERT_EQ(made.stimuli.size(), 2U);
  EXPECT_EQ(made.stimuli[0].modify.at(0).strength, 1.0);
  EXPECT_EQ(made.stimuli[1].modify.at(1).modification.tempo.factor, 1.25);
  EXPECT_EQ(made.stimuli[1].modify.at(1).modification.paths, 1.2);
}

TEST(StimulusLevels, TellWhatIsWrongWhereTheAuthorWroteIt) {
  struct Wrong {
    std::string stimuli;
    const char* place;
    const char* words;
  };
  const std::string sad = "  - {id: a, weights: {normal: 1}, modify: {emotion: sad}, levels: ";
  const Wrong wrong_ones[] = {
      {sad + "{factor: d, of: modify.strength, values: [0.1, 5]}}",
       "m.yaml:5:114: stimuli[0].modify.strength", "2"},
      {sad + "{factor: d, of: modify.strenght, values: [0.1, 0.2]}}",
       "m.yaml:5:83: stimuli[0].modify.strenght", "did you mean \"strength\""},
      {sad + "{factor: d, of: modify.emotion, values: [0.1, 0.2]}}", "stimuli[0].levels.of",
       "modify.emotion is also given"},
      {sad + "{factor: d, of: id.x, values: [0.1, 0.2]}}", "stimuli[0].levels.of",
       "x is not part of"},
      {sad + "{factor: d, of: modify.strength, values: {from: 1, to: 1, steps: 3}}}",
       "m.yaml:5:108: stimuli[0].levels.values", "the ends are equal"},
      {sad + "{factor: d, of: modify.strength, values: {from: 0, to: 1, steps: 101}}}",
       "stimuli[0].levels.values.steps", "100"},
      {sad + "{factor: d, of: modify.strength}}", "stimuli[0].levels", "values"},
      {"  - {id: a, weights: {normal: 1}, levels: {factor: d, of: output.cycles, values: {from: 1, "
       "to: 9, steps: 6}}}",
       "stimuli[0].output.cycles", "must be a whole number"},
      {"  - {id: a, weights: {normal: 1}, levels: {factor: d, of: weights.sad, values: [0, 2]}}",
       "stimuli[0].levels.of", "the weight 2 is not from 0 to 1"},
      {"  - {id: a, weights: {sad: 1}, levels: {factor: d, of: weights.sad, values: [0, 1]}}",
       "stimuli[0].levels.of", "weights.sad is also given"},
      {"  - {id: a, weights: {normal: 1}, modify: [{emotion: sad}], levels: {factor: d, of: "
       "modify.strength, values: [0, 1]}}",
       "stimuli[0].levels.of", "name one of them"},
      {"  - {id: a, weights: {normal: 1}, modify: [{emotion: sad}], levels: {factor: d, of: "
       "'modify[x].strength', values: [0, 1]}}",
       "stimuli[0].levels.of", "name one of them"},
      {"  - {id: a, weights: {normal: 1}, modify: [{emotion: sad}], levels: {factor: d, of: "
       "'modify[1].strength', values: [0, 1]}}",
       "stimuli[0].levels.of", "there is no element [1]"},
      {"  - {id: b, weights: {sad: 1}}\n" + sad +
           "{factor: d, of: modify.strength, values: [0.1, "
           "0.2]}}\n  - {id: a-0.1, weights: {sad: 1}}",
       "m.yaml:7:", "a-0.1"},
      {"  - {id: " + std::string(62, 'a') +
           ", weights: {normal: 1}, levels: {factor: d, of: weights.sad, values: [0.25, 0.5]}}",
       "stimuli[0].id", "64"}};
  for (const Wrong& one : wrong_ones) {
    const std::string told = wrong_with(one.stimuli);
    EXPECT_EQ(told.find("m.yaml"), told.rfind("m.yaml")) << told;
    EXPECT_NE(told.find(one.place), std::string::npos) << one.stimuli << "\n" << told;
    EXPECT_NE(told.find(one.words), std::string::npos) << one.stimuli << "\n" << told;
  }
}

TEST(StimulusLevels, TellTheSameFaultOfAllOnceAndWithTheAuthorsPath) {
  const std::string told = wrong_with(
      "  - {id: b, weights: {sad: 1}, levels: {factor: d, of: look.camera.fov, values: [20, 30]}}\n"
      "  - {id: a, weights: {normal: 1}, modify: {emotion: glad}, levels: {factor: d, of: "
      "modify.strength, values: {from: 0.1, to: 1, steps: 10}}}\n");
  EXPECT_EQ(told.find("there is no recipe"), told.rfind("there is no recipe")) << told;
  EXPECT_NE(told.find("m.yaml:6:"), std::string::npos) << told;
  EXPECT_NE(told.find("stimuli[1].modify.emotion"), std::string::npos) << told;
}

TEST(StimulusLevels, AreRefusedWhereTheyAreTooMany) {
  std::string stimuli;
  for (int i = 0; i < 101; ++i)
    stimuli += fmt::format(
        "  - {{id: s{}, weights: {{normal: 1}}, levels: {{factor: d, of: weights.sad, values: "
        "{{from: 0, to: 1, steps: 100}}}}}}\n",
        i);
  EXPECT_NE(wrong_with(stimuli).find("more than 10000 stimuli"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
