#include "pipeline/manifest/repetitions.h"

#include <functional>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Stimulus stimulus(const std::string& id) {
  Stimulus result;
  result.id = id;
  result.weights = {{"sad", 1.0}};
  return result;
}

/// What is told of a stimulus called "b" that differs from "a" by `change`.
std::string repetition_note(const std::function<void(Stimulus&)>& change,
                            const scenes::Figure& figure = scenes::StickOptions{}) {
  Manifest manifest;
  manifest.examples.builtin = "walks-10";
  manifest.stimuli = {stimulus("a"), stimulus("b")};
  for (Stimulus& each : manifest.stimuli) each.look.figure = figure;
  change(manifest.stimuli[1]);
  std::string told;
  for (const std::string& line : repetition_warnings(manifest)) told += line + "\n";
  return told;
}

TEST(Repetitions, AreToldWithBothIds) {
  EXPECT_EQ(repetition_note([](Stimulus&) {}),
            "b: looks identical to \"a\"; change the motion or look of one of them; ignore this if "
            "the repetition is intended\n");
}

TEST(Repetitions, DifferInNothingThatIsSeen) {
  const std::function<void(Stimulus&)> seen[] = {
      [](Stimulus& b) {
        b.weights = {{"angry", 1.0}};
      },
      [](Stimulus& b) {
        b.role = Role::target;
        b.look.colours = Colours::role;
      },
      [](Stimulus& b) { b.look.camera.view = "front"; },
      [](Stimulus& b) { b.look.set.in_place = true; },
      [](Stimulus& b) {
        b.output.size = {64, 48};
      },
      [](Stimulus& b) { b.output.cycles = 7; },
      [](Stimulus& b) { b.output.presentation.blank_before = 0.5; },
      [](Stimulus& b) {
        b.sound = StimulusSound{.file = std::filesystem::path(MIEN_SOURCE_DIR) / "README.md"};
      },
      [](Stimulus& b) { b.modify.push_back({.emotion = "sad", .strength = 0.5}); },
  };
  for (const auto& change : seen) EXPECT_EQ(repetition_note(change), "");
  const std::function<void(Stimulus&)> unseen[] = {
      [](Stimulus& b) {
        b.factors = {{"emotion", "sadness"}};
      },
      [](Stimulus& b) { b.role = Role::target; },  // in neutral colours
      [](Stimulus& b) { b.output.clips.clear(); },
      [](Stimulus& b) { b.output.video = {render::VideoKind::webm}; },
  };
  for (const auto& change : unseen) EXPECT_NE(repetition_note(change), "");
}

TEST(Repetitions, AreNoneOfDotsThatAreOthersForEachId) {
  const auto same = [](Stimulus&) {};
  EXPECT_NE(repetition_note(same, scenes::PointLightOptions{}), "");
  EXPECT_EQ(repetition_note(same, scenes::PointLightOptions{.scrambled = true}), "");
  EXPECT_EQ(repetition_note(same, scenes::PointLightOptions{.noise = 5}), "");
  EXPECT_NE(repetition_note(same, scenes::PointLightOptions{.scrambled = true, .seed = 3}), "");
  EXPECT_NE(
      repetition_note([](Stimulus& b) { b.role = Role::target; }, scenes::PointLightOptions{}), "");
  EXPECT_NE(repetition_note(same, scenes::MarkersOptions{}), "");
  EXPECT_EQ(repetition_note(same, scenes::MarkersOptions{.dots = {.scrambled = true}}), "");
}

TEST(Repetitions, AreAllOfTheFirst) {
  Manifest manifest;
  manifest.stimuli = {stimulus("a"), stimulus("b"), stimulus("c")};
  const std::vector<Repetition> found = repetitions_in(manifest);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].id, "c");
  EXPECT_EQ(found[1].first, "a");
}

}  // namespace
}  // namespace mien::pipeline
