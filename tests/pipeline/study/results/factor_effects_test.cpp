#include "pipeline/study/results/factor_effects.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/p_correction.h"
#include "pipeline/study/results/factor_contrasts.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

/// Two actors, three emotions: a 2 × 3 design of single stimuli, "k-sad" …
Manifest two_by_three(int participants = 16, std::uint64_t seed = 1) {
  Manifest manifest = two_emotion_study(participants, seed);
  manifest.stimuli.clear();
  for (const char* actor : {"k", "m"}) {
    for (const char* emotion : {"sad", "happy", "angry"}) {
      Stimulus stimulus;
      stimulus.id = fmt::format("{}-{}", actor, emotion);
      stimulus.factors = {{"actor", actor}, {"emotion", emotion}};
      manifest.stimuli.push_back(stimulus);
    }
  }
  return manifest;
}

AnswerSet answer_set_of(const Manifest& manifest, const StatedTruth& truth = {}) {
  return collect_answers(manifest, answers_to(manifest, truth));
}

const FactorEffect& effect_of(const FactorEffects& all, std::size_t scale,
                              const std::string& name) {
  const auto found = std::ranges::find(all.scales[scale].effects, name, &FactorEffect::name);
  EXPECT_NE(found, all.scales[scale].effects.end()) << name;
  return *found;
}

const FactorContrast& contrast_of(const std::vector<FactorContrast>& all, std::size_t scale,
                                  const std::string& name) {
  const auto found = std::ranges::find_if(
      all, [&](const FactorContrast& c) { return c.scale == scale && c.name == name; });
  EXPECT_NE(found, all.end()) << name;
  return *found;
}

TEST(FactorEffects, AreFoundWhereTheyWerePutIn) {
  // Emotions differ, and more in actor m; nothing differs on the other scale.
  const FactorEffects effects =
      factor_effects(answer_set_of(two_by_three(), {{{"k-sad", "sad-happy"}, -0.4},
                                                    {{"k-happy", "sad-happy"}, 0.4},
                                                    {{"m-sad", "sad-happy"}, -1.2},
                                                    {{"m-happy", "sad-happy"}, 1.2}}),
                     {});
  ASSERT_EQ(effects.scales.size(), 2u);
  ASSERT_EQ(effects.scales[0].effects.size(), 3u);
  EXPECT_EQ(effects.scales[0].people, 16);
  EXPECT_LT(effect_of(effects, 0, "emotion").adjusted, 1e-6);
  EXPECT_LT(effect_of(effects, 0, "actor × emotion").adjusted, 1e-3);
  EXPECT_GT(effect_of(effects, 0, "actor").adjusted, 0.05);
  for (const FactorEffect& effect : effects.scales[1].effects)
    EXPECT_GT(effect.adjusted, 0.05) << effect.name;
  EXPECT_EQ(effect_of(effects, 0, "actor × emotion").test.degrees, 2.0);
  EXPECT_EQ(effect_of(effects, 0, "actor × emotion").test.error_degrees, 30.0);
}

TEST(FactorEffects, HaveTheMeansOfCells) {
  const Manifest manifest = two_by_three(6);
  std::vector<AnswerRow> rows = answers_to(manifest);
  const AnswerSet answer_set = collect_answers(manifest, rows);
  const FactorEffects effects = factor_effects(answer_set, {});
  double sum = 0.0;
  for (const AnalysedRating& rating : answer_set.ratings)
    if (rating.scale == 0 && answer_set.stimuli[rating.stimulus].id == "m-angry")
      sum += rating.value;
  ASSERT_EQ(effects.scales[0].cells.size(), 6u);
  const FactorCell& last = effects.scales[0].cells.back();
  EXPECT_EQ(cell_name(answer_set.factors, effects.crossing, last.cell), "actor m, emotion angry");
  EXPECT_NEAR(last.mean, sum / 6.0, 1e-12);
  EXPECT_GT(last.margin, 0.0);
  EXPECT_LT(last.margin, 3.0);
}

TEST(FactorEffects, AreCorrectedOverAllEffectsOnAllScales) {
  AnswerSet answer_set = answer_set_of(two_by_three(8, 5));
  answer_set.correction = TestCorrection::holm;
  const FactorEffects effects = factor_effects(answer_set, {});
  std::vector<double> p_values, adjusted;
  for (const ScaleEffects& scale : effects.scales)
    for (const FactorEffect& effect : scale.effects) {
      p_values.push_back(effect.test.p_corrected);
      adjusted.push_back(effect.adjusted);
    }
  ASSERT_EQ(p_values.size(), 6u);
  EXPECT_EQ(adjusted, holm(p_values));
}

TEST(FactorEffects, LeaveOutAndCountParticipantsWhoMissACell) {
  const Manifest manifest = two_by_three(8);
  AnswerSet answer_set = answer_set_of(manifest);
  std::erase_if(answer_set.ratings, [](const AnalysedRating& rating) {
    return rating.scale == 0 &&
           ((rating.person == 2 && rating.stimulus == 4) || rating.person == 5);
  });
  const FactorEffects effects = factor_effects(answer_set, {});
  EXPECT_EQ(effects.scales[0].people, 6);
  EXPECT_EQ(effects.scales[0].incomplete, 1) << "person 5 rated nothing on this scale";
  EXPECT_EQ(effects.scales[1].people, 8);
  EXPECT_EQ(effects.scales[1].incomplete, 0);
  // A contrast needs its own cells only.
  const auto contrasts = factor_contrasts(answer_set);
  EXPECT_EQ(contrast_of(contrasts, 0, "sad − happy").within.people, 6);
  EXPECT_EQ(contrast_of(contrasts, 0, "sad − angry").within.people, 7);
  EXPECT_EQ(contrast_of(contrasts, 0, "sad − happy").incomplete, 1);
}

TEST(FactorEffects, HaveGroupsOfParticipants) {
  Manifest manifest = two_by_three(9);
  manifest.questionnaire->analysis.factorial.between = "gender";
  AnswerSet answer_set = answer_set_of(manifest);
  std::string csv = "participant,gender\n";
  for (int i = 1; i <= 9; ++i)
    csv += fmt::format("p{:03},{}\n", i,
                       i == 9       ? "other"
                       : i == 8     ? ""
                       : i % 2 == 0 ? "woman"
                                    : "man");
  for (AnalysedRating& rating : answer_set.ratings)
    if (rating.person % 2 == 0) rating.value = std::min(2.0, rating.value + 1.5);
  const FactorEffects effects = factor_effects(answer_set, {parse_csv(csv, "participants.csv")});
  const ScaleEffects& scale = effects.scales[0];
  EXPECT_EQ(scale.groups, (std::vector<std::string>{"man", "woman"}));
  EXPECT_EQ(scale.people, 7);
  EXPECT_EQ(scale.ungrouped, 2) << "one without an answer, one alone in a group";
  EXPECT_EQ(scale.cells.size(), 12u);
  EXPECT_EQ(scale.effects.size(), 7u);
  EXPECT_LT(effect_of(effects, 0, "gender").test.p, 0.02);
  EXPECT_EQ(effect_of(effects, 0, "gender × emotion").test.error_degrees, 10.0);
  // Without the table nobody is in a group.
  EXPECT_TRUE(factor_effects(answer_set, {}).scales[0].effects.empty());
}

TEST(FactorEffects, StateWhatTheyAreOf) {
  const AnswerSet answer_set = answer_set_of(two_emotion_study(6));
  const FactorEffects effects = factor_effects(answer_set, {});
  const auto sentences = crossing_sentences(answer_set, effects.crossing);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences[0],
            "Factors within participants: made (acted, modified) × emotion (sad, happy); 4 cells.");
  EXPECT_EQ(sentences[1],
            "Not in this analysis, because not all combinations of their levels were rated: walk.");
}

TEST(FactorEffects, OfTooManyFactorsAreLeftToTheManifest) {
  Manifest manifest = two_by_three(4);
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i)
    for (const char* more : {"one", "two", "three"})
      manifest.stimuli[i].factors.emplace_back(more, i % 2 == 0 ? "a" : "b");
  const FactorEffects effects = factor_effects(answer_set_of(manifest), {});
  EXPECT_TRUE(effects.scales.empty());
  EXPECT_NE(effects.reason.find("differ in 5 factors (actor, emotion, one, two, three)"),
            std::string::npos)
      << effects.reason;
  manifest.questionnaire->analysis.factorial.factors = {"actor", "emotion"};
  EXPECT_EQ(factor_effects(answer_set_of(manifest), {}).scales.size(), 2u);
}

PlannedContrast sad_against_the_rest() {
  PlannedContrast contrast;
  contrast.name = "sad against the rest";
  contrast.weights = {{"emotion", {{"sad", 1.0}, {"happy", -0.5}, {"angry", -0.5}}}};
  return contrast;
}

TEST(FactorContrasts, AreThePlannedOnesAndAllPairs) {
  Manifest manifest = two_by_three(10);
  PlannedContrast interaction;
  interaction.name = "more in m";
  interaction.weights = {{"actor", {{"m", 1.0}, {"k", -1.0}}},
                         {"emotion", {{"happy", 1.0}, {"sad", -1.0}}}};
  interaction.scales = {"sad-happy"};
  manifest.questionnaire->analysis.factorial.contrasts = {sad_against_the_rest(), interaction};
  const AnswerSet answer_set =
      answer_set_of(manifest, {{{"m-sad", "sad-happy"}, -1.0}, {{"m-happy", "sad-happy"}, 1.0}});
  const auto contrasts = factor_contrasts(answer_set);
  // Two scales: one planned on both and one on the first; one pair of actors, three of emotions.
  EXPECT_EQ(contrasts.size(), 2u + 1u + 2u * (1u + 3u));
  const FactorContrast& found = contrast_of(contrasts, 0, "more in m");
  EXPECT_EQ(found.factors, "actor × emotion");
  EXPECT_EQ(found.weights, "(m − k) × (happy − sad)");
  EXPECT_NEAR(found.within.t.mean, 2.0, 0.7);
  EXPECT_LT(found.paired_adjusted, 0.01);
  EXPECT_LT(found.dz_ends.low, found.within.dz);
  EXPECT_GT(found.dz_ends.high, found.within.dz);
  EXPECT_EQ(contrast_of(contrasts, 1, "sad against the rest").settings,
            (std::vector<std::string>{"actor k", "actor m"}));
}

TEST(FactorContrasts, ScoreParticipantsExactly) {
  // (0.1 + 0.7 − 2 · 0.4) / 3 is 0, and so are multiples of it.
  AnswerSet answer_set = answer_set_of(two_by_three(12));
  for (AnalysedRating& rating : answer_set.ratings) {
    const double emotions[] = {0.1, 0.7, 0.4};
    rating.value =
        std::round(10.0 * emotions[rating.stimulus % 3] * static_cast<double>(rating.person + 1)) /
        10.0;
  }
  PlannedContrast thirds = sad_against_the_rest();
  thirds.weights = {{"emotion", {{"sad", 1.0 / 3.0}, {"happy", 1.0 / 3.0}, {"angry", -2.0 / 3.0}}}};
  answer_set.factorial.contrasts = {thirds};
  const FactorContrast contrast = factor_contrasts(answer_set)[0];
  EXPECT_EQ(contrast.within.wilcoxon.zeros, 12);
  EXPECT_EQ(contrast.within.t.mean, 0.0);
  EXPECT_TRUE(contrast.within.all_equal);
  EXPECT_TRUE(std::isnan(contrast.dz_ends.low));
}

TEST(FactorContrasts, WithIrrationalWeightsAreScoredToo) {
  AnswerSet answer_set = answer_set_of(two_by_three(5));
  PlannedContrast contrast = sad_against_the_rest();
  const double root = std::sqrt(2.0);
  contrast.weights = {{"emotion", {{"sad", root}, {"happy", -root}}}};
  answer_set.factorial.contrasts = {contrast};
  const auto all = factor_contrasts(answer_set);
  EXPECT_NEAR(all[0].within.t.mean, root * contrast_of(all, 0, "sad − happy").within.t.mean, 1e-12);
}

TEST(FactorContrasts, OfTwoLevelsHaveTheTestOfTheMainEffect) {
  const AnswerSet answer_set = answer_set_of(two_by_three(7));
  const FactorEffect effect = effect_of(factor_effects(answer_set, {}), 0, "actor");
  const auto contrasts = factor_contrasts(answer_set);
  const FactorContrast& pair = contrast_of(contrasts, 0, "k − m");
  EXPECT_NEAR(pair.within.t.t * pair.within.t.t, effect.test.f, 1e-9);
  EXPECT_NEAR(pair.within.t.p, effect.test.p, 1e-12);
}

TEST(FactorContrasts, AreCorrectedByKindAndFactor) {
  Manifest manifest = two_by_three(12, 9);
  manifest.questionnaire->analysis.factorial.contrasts = {sad_against_the_rest()};
  const auto contrasts = factor_contrasts(answer_set_of(manifest));
  const auto expect_holm = [&](ContrastKind kind, const std::string& factors, std::size_t count) {
    std::vector<double> p_values, adjusted;
    for (const FactorContrast& c : contrasts) {
      if (c.kind != kind || c.factors != factors) continue;
      p_values.push_back(c.within.t.p);
      adjusted.push_back(c.paired_adjusted);
    }
    EXPECT_EQ(p_values.size(), count);
    EXPECT_EQ(adjusted, holm(p_values));
  };
  expect_holm(ContrastKind::planned, "emotion", 2);
  expect_holm(ContrastKind::pairwise, "emotion", 6);
  expect_holm(ContrastKind::pairwise, "actor", 2);
}

}  // namespace
}  // namespace mien::pipeline
