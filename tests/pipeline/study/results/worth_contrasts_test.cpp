// Worths of conditions instead of stimuli, and differences between worths.

#include "pipeline/study/results/worth_contrasts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/study/results/pair_worth.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

const StatedTruth truth = {{{"acted-sad", "sad-happy"}, -0.4},
                           {{"sad", "sad-happy"}, -0.2},
                           {{"walk", "sad-happy"}, 0.0},
                           {{"happy", "sad-happy"}, 0.2},
                           {{"acted-happy", "sad-happy"}, 0.4}};

/// Noisy enough that every stimulus is chosen and not chosen.
const SimulatedParticipants undecided_people = {
    .spread = RatingSpread{.participant = 0.3, .stimulus = 0.0, .residual = 0.8},
    .attention_pass_rate = 1.0};

/// The worth of the pairs of five stimuli, by the factors of the plan.
struct Analysed {
  AnswerSet answers;
  PairWorth worth;
};

Analysed analysed(const FactorialPlan& plan, int people = 24) {
  Manifest manifest = all_pairs_study(people);
  manifest.questionnaire->analysis.factorial = plan;
  AnswerSet answers = collect_answers(manifest, answers_to(manifest, truth, undecided_people));
  PairWorth worth = worths_of(answers).at(0);
  return {std::move(answers), std::move(worth)};
}

const WorthContrast& contrast_named(const PairWorth& worth, const std::string& name) {
  const auto found = std::ranges::find(worth.contrasts, name, &WorthContrast::name);
  EXPECT_NE(found, worth.contrasts.end()) << name;
  return *found;
}

double worth_named(const PairWorth& worth, const std::string& name) {
  return std::ranges::find(worth.stimuli, name, &StimulusWorth::name)->worth;
}

PlannedContrast happy_against_sad() {
  PlannedContrast contrast;
  contrast.name = "happy against sad";
  contrast.weights = {{"emotion", {{"happy", 1.0}, {"sad", -1.0}}}};
  return contrast;
}

TEST(ComparedConditions, AreStimuliWithoutFactors) {
  const ComparedConditions conditions = compared_conditions(analysed({}).answers);
  EXPECT_EQ(conditions.names,
            (std::vector<std::string>{"walk", "acted-sad", "acted-happy", "sad", "happy"}));
  EXPECT_EQ(conditions.of_stimulus, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(ComparedConditions, PoolStimuliWithTheSameLevels) {
  const ComparedConditions conditions =
      compared_conditions(analysed({.factors = {"emotion"}}).answers);
  EXPECT_EQ(conditions.names, (std::vector<std::string>{"neutral", "sad", "happy"}));
  EXPECT_EQ(conditions.of_stimulus, (std::vector<std::size_t>{0, 1, 2, 1, 2}));
  const ComparedConditions both =
      compared_conditions(analysed({.factors = {"made", "emotion"}}).answers);
  EXPECT_EQ(both.names, (std::vector<std::string>{"as-is, neutral", "acted, sad", "acted, happy",
                                                  "modified, sad", "modified, happy"}));
}

TEST(WorthOfConditions, IsThatOfPooledComparisons) {
  const Analysed study = analysed({.factors = {"emotion"}});
  ASSERT_EQ(study.worth.stimuli.size(), 3u);
  // Sad with modified sad, happy with modified happy: once by each of the 24 participants.
  EXPECT_EQ(study.worth.within_conditions, 48);
  EXPECT_EQ(study.worth.comparisons, 8 * 24);
  const std::vector<std::size_t> condition = {0, 1, 2, 1, 2};
  std::vector<PairCount> counts;
  for (const AnalysedPreference& answer : study.answers.preferences) {
    const std::size_t chosen = condition[answer.chosen], other = condition[answer.other];
    if (chosen == other) continue;
    PairCount& count = counts.emplace_back();
    count.first = answer.is_left_chosen ? chosen : other;
    count.second = answer.is_left_chosen ? other : chosen;
    (answer.is_left_chosen ? count.first_wins : count.second_wins) = 1.0;
  }
  const BradleyTerry pooled = bradley_terry(counts, 3, OrderEffect::estimated);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(study.worth.stimuli[i].worth, pooled.worth[i], 1e-9);
}

TEST(WorthContrasts, OfPairsAreDifferencesOfWorths) {
  const Analysed study = analysed({});
  EXPECT_EQ(study.worth.contrasts.size(), 10u);
  for (const WorthContrast& contrast : study.worth.contrasts) {
    EXPECT_EQ(contrast.kind, ContrastKind::pairwise);
    EXPECT_LT(contrast.ends.low, contrast.difference);
    EXPECT_GT(contrast.ends.high, contrast.difference);
    EXPECT_EQ(contrast.degrees, 23.0);
    EXPECT_GE(contrast.adjusted, contrast.p);
  }
  const WorthContrast& one = contrast_named(study.worth, "acted-happy − sad");
  EXPECT_NEAR(one.difference,
              worth_named(study.worth, "acted-happy") - worth_named(study.worth, "sad"), 1e-12);
  EXPECT_LT(one.adjusted, 0.01);
  EXPECT_NEAR(one.statistic, one.difference / one.error, 1e-12);
}

TEST(WorthContrasts, ThatArePlannedAverageOverMatchedSettings) {
  const Analysed study = analysed({.contrasts = {happy_against_sad()}});
  const WorthContrast& planned = study.worth.contrasts.at(0);
  EXPECT_EQ(planned.kind, ContrastKind::planned);
  EXPECT_EQ(planned.weights, "happy − sad");
  EXPECT_EQ(planned.settings, (std::vector<std::string>{"made acted", "made modified"}));
  const auto worth = [&](const char* id) { return worth_named(study.worth, id); };
  EXPECT_NEAR(planned.difference,
              0.5 * (worth("acted-happy") - worth("acted-sad") + worth("happy") - worth("sad")),
              1e-12);
  // It is the only planned contrast: there is nothing to correct.
  EXPECT_EQ(planned.adjusted, planned.p);
}

TEST(WorthContrasts, AreOnlyForTheirScales) {
  PlannedContrast elsewhere = happy_against_sad();
  elsewhere.scales = {"weak-strong"};
  const Analysed study = analysed({.contrasts = {elsewhere}});
  EXPECT_TRUE(std::ranges::none_of(study.worth.contrasts, [](const WorthContrast& contrast) {
    return contrast.kind == ContrastKind::planned;
  }));
}

TEST(WorthContrasts, TreatAnswersAsIndependentWithFewParticipants) {
  const Analysed study = analysed({}, 9);
  const WorthContrast& one = contrast_named(study.worth, "acted-sad − acted-happy");
  EXPECT_TRUE(std::isnan(one.degrees));
  EXPECT_NEAR(one.ends.high - one.ends.low, 2.0 * 1.959964 * one.error, 1e-5);
  EXPECT_NEAR(one.p, std::erfc(std::abs(one.statistic) / std::sqrt(2.0)), 1e-12);
}

TEST(WorthContrasts, HaveNoNumberIfAWorthIsNotFinite) {
  Manifest manifest = all_pairs_study(24);
  manifest.questionnaire->analysis.factorial.contrasts = {happy_against_sad()};
  std::vector<AnswerRow> rows = answers_to(manifest, truth, undecided_people);
  for (AnswerRow& row : rows) {
    if (!row.counts() || (row.stimulus != "happy" && row.against != "happy")) continue;
    row.value_raw = row.stimulus == "happy" ? "left" : "right";
    row.value = "happy";
  }
  const PairWorth worth = worths_of(collect_answers(manifest, rows)).at(0);
  EXPECT_TRUE(std::isnan(worth.contrasts.at(0).difference));
  EXPECT_TRUE(std::isnan(worth.contrasts.at(0).p));
  EXPECT_TRUE(std::isnan(contrast_named(worth, "walk − happy").difference));
  EXPECT_TRUE(std::isfinite(contrast_named(worth, "walk − sad").p));
}

}  // namespace
}  // namespace mien::pipeline
