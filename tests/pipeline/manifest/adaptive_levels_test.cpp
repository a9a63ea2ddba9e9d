#include "pipeline/manifest/adaptive_levels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/adaptive_text.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/study/thresholds/dose_study.h"

namespace mien::pipeline {
namespace {

using mien::test::adaptive_members;
using mien::test::dose_study;
using Names = std::vector<std::string>;

Names texts_of(const AdaptiveLevels& levels) {
  Names texts;
  for (const AdaptiveLevel& level : levels.grid) texts.push_back(level.text);
  return texts;
}

TEST(AdaptiveLevels, GoFromTheHardestToTheEasiestWithoutThatOfTheReferences) {
  const AdaptiveLevels rising =
      adaptive_levels(dose_study(adaptive_members("yes_no", "factor: dose")));
  EXPECT_EQ(texts_of(rising), (Names{"0.5", "1", "1.5", "2", "2.5", "3"}));
  EXPECT_EQ(rising.references, (Names{"a0", "b0"}));
  EXPECT_EQ(rising.grid[1].stimuli, (Names{"a2", "b2"}));
  EXPECT_EQ(rising.grid[1].value, 1.0);
  const AdaptiveLevels falling =
      adaptive_levels(dose_study(adaptive_members("yes_no", "factor: dots, easier: falling")));
  EXPECT_EQ(texts_of(falling), (Names{"60", "50", "40", "30", "20", "10"}));
  EXPECT_EQ(falling.references, (Names{"a0", "b0"})) << "many dots are hardest";
}

TEST(AdaptiveLevels, TakeTheStatedSignal) {
  const Manifest manifest = dose_study(
      adaptive_members("two_interval", "factor: dots, easier: falling") + ", signal: {actor: [b]}");
  const AdaptiveLevels levels = adaptive_levels(manifest);
  EXPECT_EQ(texts_of(levels), (Names{"70", "60", "50", "40", "30", "20", "10"}));
  EXPECT_EQ(levels.grid[0].stimuli, Names{"b0"});
  EXPECT_EQ(levels.references.size(), 7u);
  // Foils with the same number of dots stand for a level, not any foil.
  EXPECT_EQ(references_of(manifest, levels, "b4"), Names{"a4"});
}

TEST(AdaptiveLevels, ReferencesAgreeInTheMostFactors) {
  const Manifest manifest = dose_study(adaptive_members("two_interval", "factor: dose"));
  const AdaptiveLevels levels = adaptive_levels(manifest);
  EXPECT_EQ(references_of(manifest, levels, "a3"), Names{"a0"}) << "the same actor";
  EXPECT_EQ(references_of(manifest, levels, "b6"), Names{"b0"});
  EXPECT_EQ(signal_stimuli(manifest).size(), 12u);
}

TEST(AdaptiveLevels, StaircasesConvergeToPublishedProportions) {
  AdaptiveTrialSettings staircase{.method = AdaptiveMethod::staircase};
  EXPECT_NEAR(threshold_proportion(staircase), std::sqrt(0.5), 1e-9);  // Levitt 1971
  staircase.down = 3;
  EXPECT_NEAR(threshold_proportion(staircase), std::cbrt(0.5), 1e-9);
  staircase.down = 1;
  staircase.step = {.up = 3, .down = 1};
  EXPECT_NEAR(threshold_proportion(staircase), 0.75, 1e-9);  // Kaernbach 1991
  staircase.proportion = 0.6;
  EXPECT_EQ(threshold_proportion(staircase), 0.6);
  EXPECT_EQ(threshold_proportion({}), 0.75);
}

TEST(AdaptiveLevels, NoiseIsAShareOfAllTrials) {
  const auto asked = [](const std::string& form, const std::string& more) {
    return *dose_study(adaptive_members(form, "factor: dose, " + more)).questionnaire;
  };
  EXPECT_EQ(adaptive_noise_trials(asked("yes_no", "trials: 40, tracks: 2")), 20);
  EXPECT_EQ(adaptive_session_trials(asked("yes_no", "trials: 40, tracks: 2")), 100);
  EXPECT_EQ(adaptive_noise_trials(asked("same_different", "trials: 30, noise: 0.5")), 30);
  EXPECT_EQ(adaptive_noise_trials(asked("yes_no", "trials: 5, noise: 0.05")), 1) << "at least";
  EXPECT_EQ(adaptive_noise_trials(asked("two_interval", "trials: 40")), 0);
}

TEST(AdaptiveLevels, StepsAreOneNumberOrTwo) {
  const auto steps = [](const std::string& step) {
    return dose_study(adaptive_members("yes_no", "method: staircase, factor: dose, step: " + step))
        .questionnaire->adaptive.step;
  };
  EXPECT_EQ(steps("2"), (StaircaseSteps{2, 2}));
  EXPECT_EQ(steps("{up: 3}"), (StaircaseSteps{3, 1}));
  EXPECT_EQ(StaircaseStepsForm::write({2, 2}, {}), OrderedJson(2));
  EXPECT_EQ(StaircaseStepsForm::write({3, 1}, {}), (OrderedJson{{"up", 3}, {"down", 1}}));
}

TEST(AdaptiveLevels, AreStatedInThePlanOfTheAnalysis) {
  const auto plan = [](const std::string& form, const std::string& more) {
    return adaptive_plan_text(dose_study(adaptive_members(form, more)));
  };
  const std::string staircase = plan(
      "yes_no", "method: staircase, factor: dose, down: 3, reversals: 8, trials: 60, tracks: 2");
  EXPECT_EQ(staircase,
            "Adaptive trials. 6 levels of dose (0.5, 1, 1.5, 2, 2.5, 3), from the hardest to the "
            "easiest. 30 further trials at random places show one of 2 stimuli without the signal. "
            "A staircase begins with the easiest level; after 3 positive answers in succession it "
            "goes 1 place to a harder level, after 1 negative answer 1 place to an easier one, and "
            "so comes to 79.4 % answers “yes”. There are 2 tracks with answers of their own, "
            "interleaved at random in the plans; each ends after 8 reversals, or 60 trials.\n");
  const std::string quest = plan("two_interval", "factor: dose");
  EXPECT_NE(quest.find("QUEST+ chooses the level"), std::string::npos) << quest;
  EXPECT_NE(quest.find("There is 1 track with answers of its own; it ends after 40 trials."),
            std::string::npos)
      << quest;
}

}  // namespace
}  // namespace mien::pipeline
