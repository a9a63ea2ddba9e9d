#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/reading/recipes.h"

namespace mien::pipeline {
namespace {

ManifestReading parse_with(const std::string& modify) {
  return parse_manifest(
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nstimuli:\n"
      "- id: a\n  weights: {normal: 1}\n  modify: " +
          modify + "\n",
      "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
}

std::string faults_of(const std::string& modify) {
  std::string text;
  for (const Fault& fault : parse_with(modify).faults) text += to_string(fault) + "\n";
  return text;
}

motion::Modification read_as(const std::string& modify) {
  const ManifestReading reading = parse_with(modify);
  EXPECT_TRUE(reading.faults.empty()) << faults_of(modify);
  return reading.manifest.stimuli.at(0).modify.at(0).modification;
}

TEST(TimeAndTension, AreReadInEachOfTheirForms) {
  EXPECT_EQ(read_as("{tempo: 1.2}").tempo, motion::Tempo(1.2));
  EXPECT_EQ(read_as("{tempo: 1.2}").gravity, motion::TempoGravity::scaled);
  const motion::Modification curve = read_as("{tempo: [[0, 1], [0.5, 1.4]], gravity: keep}");
  EXPECT_EQ(curve.tempo.curve, (std::vector<motion::TempoPoint>{{0.0, 1.0}, {0.5, 1.4}}));
  EXPECT_EQ(curve.gravity, motion::TempoGravity::kept);
  EXPECT_EQ(read_as("{stiffness: 0.4}").stiffness, (motion::Stiffness{0.4, 0.4, 0.4, 0.4, 0.4}));
  EXPECT_EQ(read_as("{stiffness: 1.5}").stiffness, (motion::Stiffness{1.5, 1.5, 1.5, 1.5, 1.0}));
  EXPECT_EQ(read_as("{stiffness: {arms: 0.3, right-arm: 0.6, legs: 0.5}, weight: 1.2}").stiffness,
            (motion::Stiffness{1.0, 1.0, 0.3, 0.6, 0.5}));
  EXPECT_EQ(read_as("{stiffness: {arms: 0.3}, weight: 1.2}").weight, 1.2);
}

TEST(TimeAndTension, ReplaceThoseOfARecipe) {
  const motion::Modification own = read_as("{emotion: tired}");
  const motion::Modification other =
      read_as("{emotion: tired, tempo: [[0, 2]], stiffness: {head: 0.5}}");
  EXPECT_EQ(other.tempo.curve.size(), 1U);
  EXPECT_EQ(other.stiffness, (motion::Stiffness{.head = 0.5}));
  EXPECT_EQ(other.paths, own.paths);
}

TEST(TimeAndTension, AreWrittenAsTheyAreRead) {
  for (const char* text :
       {"{tempo: 0.8}", "{tempo: [[0, 1], [0.25, 1.4], [1, 0.5]], gravity: keep}",
        "{stiffness: {left-arm: 0.2, legs: 0.7}, weight: 0.5}", "{stiffness: {arms: 1.5}}"}) {
    const motion::Modification first = read_as(text);
    const motion::Modification second = read_as(written(first, {}).dump());
    EXPECT_EQ(second.tempo, first.tempo) << text;
    EXPECT_EQ(second.gravity, first.gravity) << text;
    EXPECT_EQ(second.stiffness, first.stiffness) << text;
    EXPECT_EQ(second.weight, first.weight) << text;
  }
  EXPECT_EQ(written(motion::Modification{}, {}).dump(), "{}");
}

TEST(TimeAndTension, AreToldWhatIsWrongWithThem) {
  struct Case {
    const char* modify;
    const char* faults;
  };
  for (const Case& each : {
           Case{"{tempo: [[0, 1], [0, 1.4]]}",
                "/nowhere/m.yaml:7:29: stimuli[0].modify.tempo[1][0]: the moment 0 does not follow "
                "0; "
                "give the points of the curve in the order of their moments, each once\n"},
           Case{"{tempo: [[0.5, 1], [0.2, 1.4]]}",
                "/nowhere/m.yaml:7:31: stimuli[0].modify.tempo[1][0]: the moment 0.2 does not "
                "follow "
                "0.5; give the points of the curve in the order of their moments, each once\n"},
           Case{"{tempo: [[0, 1], [2, 1.4]]}",
                "/nowhere/m.yaml:7:29: stimuli[0].modify.tempo[1][0]: the moment 2 is not in the "
                "motion; give a share of its duration, from 0 (beginning) to 1 (end)\n"},
           Case{"{tempo: [[0, 0.1]]}",
                "/nowhere/m.yaml:7:24: stimuli[0].modify.tempo[0][1]: the speed factor is 0.1; "
                "give a "
                "number from 0.25 to 4\n"},
       }) {
    EXPECT_EQ(faults_of(each.modify), each.faults);
  }
  // The schema's; each one fault, at its place.
  for (const char* wrong :
       {"{tempo: 5}", "{tempo: fast}", "{tempo: []}", "{tempo: [0.5]}", "{tempo: [[0]]}",
        "{tempo: [[0, .nan]]}", "{tempo: [[0, 5]]}", "{tempo: .nan}", "{stiffness: -1}",
        "{stiffness: {arms: 3}}", "{stiffness: {legs: 1.5}}", "{stiffness: {arm: 0.5}}",
        "{stiffness: slack}", "{weight: 4}", "{weight: .inf}", "{gravity: none}",
        "{stiffness: {arms: .nan}}"}) {
    const std::string faults = faults_of(wrong);
    EXPECT_EQ(std::count(faults.begin(), faults.end(), '\n'), 1) << wrong << ": " << faults;
    EXPECT_EQ(faults.find("/nowhere/m.yaml:7:"), 0U) << wrong << ": " << faults;
  }
  for (const char* key : {"gravity: keep", "stiffness: 0.5", "weight: 2"}) {
    EXPECT_NE(faults_of("{method: hsu, neutral: normal, styled: sad, " + std::string(key) + "}")
                  .find("a step with a method has no other changes"),
              std::string::npos);
  }
}

TEST(TimeAndTension, OfARecipeAreToldWithTheirPlace) {
  try {
    parse_recipes("recipes:\n  haste: {tempo: [[0.2, 1], [0.1, 2]]}\n", "/nowhere/r.yaml");
    FAIL() << "nothing was thrown";
  } catch (const Faults& faults) {
    EXPECT_EQ(
        to_string(faults.list().at(0)),
        "/nowhere/r.yaml:2:30: recipes.haste.tempo[1][0]: the moment 0.1 does not follow 0.2; "
        "give the points of the curve in the order of their moments, each once");
  }
}

}  // namespace
}  // namespace mien::pipeline
