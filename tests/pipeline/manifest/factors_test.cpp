#include "pipeline/manifest/factors.h"

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"

namespace mien::pipeline {
namespace {

ManifestReading reading_of(const std::string& stimuli) {
  return parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n" + stimuli,
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
}

Manifest manifest_of(const std::string& stimuli) {
  const ManifestReading reading = reading_of(stimuli);
  EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  return reading.manifest;
}

TEST(Factors, AreTextsNumbersAndTruthValuesInTheOrderOfTheManifest) {
  const Manifest manifest = manifest_of(
      "  - {id: a, weights: {sad: 1, normal: 1}, factors: {z: 1, level: 0.80, shown: true, who: "
      "\"7\"}}\n");
  EXPECT_EQ(manifest.stimuli[0].factors,
            (Factors{{"z", "1"}, {"level", "0.8"}, {"shown", "true"}, {"who", "7"}}));
}

TEST(Factors, ThatArePlainFromTheStimulusAreFilledIn) {
  const Manifest manifest = manifest_of(
      "  - {id: a, weights: {sad: 1}, modify: [{emotion: tired, strength: 0.5}, {tempo: 1.1}, "
      "{emotion: angry}]}\n"
      "  - {id: b, weights: {sad: 1, normal: 0}}\n"
      "  - {id: c, weights: {sad: 1, normal: 2}}\n");
  EXPECT_EQ(level_of(manifest.stimuli[0], "emotion"), "tired+angry");
  EXPECT_EQ(level_of(manifest.stimuli[0], "strength"), "0.5+1");
  EXPECT_EQ(level_of(manifest.stimuli[0], "example"), "sad");
  EXPECT_EQ(level_of(manifest.stimuli[1], "example"), "sad");
  EXPECT_TRUE(levels_of(manifest.stimuli[2]).empty());
}

TEST(Factors, ThatAreStatedGoBeforeWhatIsPlain) {
  const Manifest manifest = manifest_of(
      "  - {id: a, weights: {sad: 1}, factors: {actor: k, emotion: acted sad}}\n"
      "  - {id: b, weights: {normal: 1}, modify: {emotion: sad}}\n");
  EXPECT_EQ(level_of(manifest.stimuli[0], "emotion"), "acted sad");
  EXPECT_EQ(level_of(manifest.stimuli[1], "emotion"), "sad");
  EXPECT_EQ(level_of(manifest.stimuli[1], "actor"), "");
  EXPECT_EQ(factors_of(manifest),
            (std::vector<std::string>{"actor", "emotion", "example", "strength"}));
}

TEST(Factors, AreRefusedWhenTheyCannotBeColumns) {
  const ManifestReading name =
      reading_of("  - {id: a, weights: {sad: 1}, factors: {\"my actor\": k}}\n");
  ASSERT_EQ(name.faults.size(), 1u);
  EXPECT_EQ(to_string(name.faults[0]),
            "/nowhere/m.yaml:5:42: stimuli[0].factors.my actor: \"my actor\" is not a valid column "
            "name; begin with a letter, and use letters, digits and _");
  const ManifestReading level =
      reading_of("  - {id: a, weights: {sad: 1}, factors: {actor: [k, m]}}\n");
  ASSERT_EQ(level.faults.size(), 1u);
  EXPECT_EQ(level.faults[0].wrong, "must be text or a number or true or false but is a list");
}

}  // namespace
}  // namespace mien::pipeline
