// Grid trials by simulated participants whose ratings are known.

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/quality_rules.h"
#include "pipeline/study/results/factor_effects.h"
#include "pipeline/study/results/grid_results.h"
#include "pipeline/study/results/grid_screening.h"
#include "pipeline/study/results/quality_lists.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

const std::vector<std::string> made_levels = {"captured", "model-a", "model-b", "mismatched"};

/// Twelve sets, one of each speech, of four stimuli that were made in different ways.
Manifest grid_study(int participants, int speeches = 12, std::uint64_t seed = 1) {
  Manifest manifest;
  manifest.study = "gestures";
  manifest.seed = seed;
  for (int speech = 1; speech <= speeches; ++speech)
    for (const std::string& made : made_levels) {
      Stimulus stimulus;
      stimulus.id = made + "-" + std::to_string(speech);
      stimulus.factors = {{"speech", std::to_string(speech)}, {"made", made}};
      manifest.stimuli.push_back(stimulus);
    }
  Questionnaire asked;
  asked.participants = participants;
  asked.scales.ids = {"sad-happy"};
  asked.trials = &grid_form;
  asked.grid.alike = {"speech"};
  asked.grid.reference.levels = {{"made", {"captured"}}};
  asked.grid.anchor.levels = {{"made", {"mismatched"}}};
  manifest.questionnaire = asked;
  return manifest;
}

/// Mean ratings by the level of `made`.
StatedTruth truth_by_level(const Manifest& manifest, const std::map<std::string, double>& means) {
  StatedTruth stated;
  for (const Stimulus& stimulus : manifest.stimuli)
    stated[{stimulus.id, "sad-happy"}] = means.at(stimulus.factors[1].second);
  return stated;
}

const std::map<std::string, double> clear_means = {
    {"captured", 97.0}, {"model-a", 60.0}, {"model-b", 50.0}, {"mismatched", 25.0}};

/// Participants whose ratings seldom reach an end of the scale.
const SimulatedParticipants grid_people = {
    .spread = RatingSpread{.participant = 5.0, .stimulus = 0.0, .residual = 8.0},
    .attention_pass_rate = 1.0,
    .reference_recognition_rate = 1.0};

AnswerSet grid_answers(const Manifest& manifest, const std::map<std::string, double>& means,
                       const SimulatedParticipants& people = grid_people) {
  return collect_answers(manifest, answers_to(manifest, truth_by_level(manifest, means), people));
}

TEST(GridResults, FindTheMeansOfTheConditionsAndTheirDifferences) {
  const Manifest manifest = grid_study(30);
  const GridResults found = grid_results(grid_answers(manifest, clear_means));
  ASSERT_EQ(found.conditions.size(), 4u);
  ASSERT_EQ(found.means.size(), 4u);
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found.conditions[i].name, made_levels[i]);
    places[found.conditions[i].name] = i;
    EXPECT_EQ(found.means[i].people, 30);
    EXPECT_EQ(found.means[i].answers, 360);
  }
  EXPECT_EQ(found.conditions[0].role, "reference");
  EXPECT_EQ(found.conditions[1].role, "");
  EXPECT_EQ(found.conditions[3].role, "anchor");
  EXPECT_DOUBLE_EQ(found.means[0].mean, 100.0);  // all recognise it
  // The standard error of a mean is about √(5² + 8² / 12) / √30 = 1.
  EXPECT_NEAR(found.means[1].mean, 60.0, 4.0);
  EXPECT_NEAR(found.means[2].mean, 50.0, 4.0);
  EXPECT_NEAR(found.means[3].mean, 25.0, 4.0);
  ASSERT_EQ(found.differences.size(), 6u);
  const auto models = std::ranges::find_if(
      found.differences, [](const GridDifference& one) { return one.one == 1 && one.other == 2; });
  ASSERT_NE(models, found.differences.end());
  // Response biases cancel out.
  EXPECT_NEAR(models->within.t.mean, 10.0, 2.5);
  EXPECT_LT(models->within.t.low(0.95), 10.0);
  EXPECT_GT(models->within.t.high(0.95), 10.0);
  EXPECT_EQ(models->within.people, 30);
  EXPECT_LT(models->paired_adjusted, 0.001);
}

/// How often 95 % intervals have the true value, and how often a difference that is none is
/// significant.
TEST(GridResults, HaveIntervalsThatCoverTheTruthAndTestsThatKeepTheirLevel) {
  const std::map<std::string, double> means = {
      {"captured", 97.0}, {"model-a", 50.0}, {"model-b", 50.0}, {"mismatched", 30.0}};
  constexpr int studies = 400;
  int covered = 0, differences_covered = 0, significant = 0;
  for (int study = 0; study < studies; ++study) {
    const Manifest manifest = grid_study(8, 3, 1000 + static_cast<std::uint64_t>(study));
    const GridResults found = grid_results(grid_answers(manifest, means));
    covered += found.means[1].ends.low <= 50.0 && found.means[1].ends.high >= 50.0;
    for (const GridDifference& one : found.differences) {
      if (one.one != 1 || one.other != 2) continue;
      differences_covered += one.within.t.low(0.95) <= 0.0 && one.within.t.high(0.95) >= 0.0;
      significant += one.within.t.p < 0.05;
    }
  }
  RecordProperty("means covered", covered);
  RecordProperty("differences covered", differences_covered);
  // 99.9 % limits of a binomial count with n = 400 and p = 0.95.
  EXPECT_GE(covered, 365);
  EXPECT_LE(covered, 394);
  EXPECT_GE(differences_covered, 365);
  EXPECT_LE(differences_covered, 394);
  EXPECT_EQ(significant, studies - differences_covered);
}

TEST(GridResults, ComparePeopleInTheSetsInWhichTheyRatedBothConditions) {
  AnswerSet answers;
  answers.correction = TestCorrection::holm;
  answers.scales.push_back({.id = "s", .least = 0.0, .most = 100.0});
  answers.people = {"p1", "p2"};
  for (const char* id : {"a1", "b1", "a2", "b2"})
    answers.stimuli.push_back({.id = id, .factors = {{"made", std::string(1, id[0])}}});
  answers.grid = {{.stimuli = {"a1", "b1"}}, {.stimuli = {"a2", "b2"}}};
  // p1 rated both of the first set, and one of the second, which must not count.
  answers.ratings = {{0, 0, 0, 80.0}, {0, 1, 0, 60.0}, {0, 2, 0, 10.0}, {1, 0, 0, 70.0},
                     {1, 1, 0, 60.0}, {1, 2, 0, 90.0}, {1, 3, 0, 40.0}};
  const GridResults found = grid_results(answers);
  ASSERT_EQ(found.differences.size(), 1u);
  EXPECT_EQ(found.differences[0].within.people, 2);
  EXPECT_DOUBLE_EQ(found.differences[0].within.t.mean, (20.0 + (10.0 + 50.0) / 2.0) / 2.0);
  ASSERT_EQ(found.means.size(), 2u);
  EXPECT_DOUBLE_EQ(found.means[0].mean, (45.0 + 80.0) / 2.0);
  EXPECT_EQ(found.means[0].answers, 4);
}

TEST(GridResults, OfStimuliWithoutFactorsHaveAConditionEach) {
  AnswerSet answers;
  answers.scales.push_back({.id = "s", .least = 0.0, .most = 100.0});
  answers.people = {"p1"};
  for (const char* id : {"a", "b"}) answers.stimuli.push_back({.id = id});
  answers.grid = {{.stimuli = {"a", "b"}, .reference = "b"}};
  answers.ratings = {{0, 0, 0, 80.0}, {0, 1, 0, 60.0}};
  const GridResults found = grid_results(answers);
  ASSERT_EQ(found.conditions.size(), 2u);
  EXPECT_EQ(found.conditions[0].name, "a");
  EXPECT_EQ(found.conditions[1].role, "reference");
  EXPECT_TRUE(std::isnan(found.means[0].ends.low));
}

TEST(GridResults, IgnoreFactorsOfSingleMotions) {
  Manifest manifest = grid_study(3, 2);
  manifest.stimuli[0].weights = {{"normal", 1.0}};  // the level normal of the factor example
  manifest.stimuli[4].weights = {{"sad", 1.0}};
  const GridResults found = grid_results(grid_answers(manifest, clear_means));
  ASSERT_EQ(found.conditions.size(), 4u);
  EXPECT_EQ(found.conditions[0].name, "captured");
}

TEST(GridResults, AreEmptyForOtherTrials) {
  const Manifest manifest = two_emotion_study(4);
  const GridResults found = grid_results(collect_answers(manifest, answers_to(manifest)));
  EXPECT_TRUE(found.conditions.empty());
  EXPECT_TRUE(found.means.empty());
}

TEST(GridAnswers, AreAnalysedByTheFactorsOfTheDesign) {
  Manifest manifest = grid_study(12, 4);
  manifest.questionnaire->analysis.factorial.factors = {"made"};
  const AnswerSet answers = grid_answers(manifest, clear_means);
  const FactorEffects effects = factor_effects(answers, {});
  ASSERT_EQ(effects.crossing.factors.size(), 1u);
  EXPECT_EQ(effects.crossing.cells.size(), 4u);
  ASSERT_EQ(effects.scales.size(), 1u);
  EXPECT_EQ(effects.scales[0].people, 12);
  ASSERT_EQ(effects.scales[0].cells.size(), 4u);
  for (const FactorCell& cell : effects.scales[0].cells)
    EXPECT_NEAR(cell.mean, cell.cell == 0 ? 100.0 : clear_means.at(made_levels[cell.cell]), 7.0);
}

TEST(GridAnswers, GoFromZeroToOneHundredWhateverTheRangeOfTheScale) {
  const Manifest manifest = grid_study(3, 2);
  const auto rows = answers_to(manifest, truth_by_level(manifest, clear_means), grid_people);
  ASSERT_EQ(rows.size(), 3u * 2u * 4u);
  for (const AnswerRow& row : rows) {
    EXPECT_EQ(row.value, row.value_raw);
    EXPECT_EQ(row.item, "sad-happy");
    EXPECT_TRUE(row.against.starts_with("captured-")) << row.against;
    EXPECT_EQ(row.against.substr(row.against.rfind('-')),
              row.stimulus.substr(row.stimulus.rfind('-')));
  }
  const AnswerSet answers = collect_answers(manifest, rows);
  EXPECT_EQ(answers.ratings.size(), rows.size());
  EXPECT_EQ(answers.scales[0].least, 0.0);
  EXPECT_EQ(answers.scales[0].most, 100.0);
  auto wrong = rows;
  wrong[0].value = wrong[0].value_raw = "101";
  EXPECT_THROW(collect_answers(manifest, wrong), Faults);
  wrong = rows;
  wrong[0].value = "1";
  wrong[0].value_raw = "2";
  EXPECT_THROW(collect_answers(manifest, wrong), Faults);
}

/// A rating of a grid.
AnswerRow grid_row(const std::string& participant, int trial, const std::string& stimulus,
                   double value) {
  AnswerRow row;
  row.participant = participant;
  row.trial = trial;
  row.kind = grid_form.name;
  row.stimulus = stimulus;
  row.item = "s";
  row.value = std::to_string(value);
  return row;
}

std::vector<GridSet> numbered_sets(int count) {
  std::vector<GridSet> sets;
  for (int i = 0; i < count; ++i)
    sets.push_back(
        {.stimuli = {}, .reference = "r" + std::to_string(i), .anchor = "a" + std::to_string(i)});
  return sets;
}

TEST(PostScreening, FlagsWhoMissesTheReferenceInMoreThanFifteenPercentOfTheTrials) {
  std::vector<AnswerRow> rows;
  for (int i = 0; i < 20; ++i) {
    const std::string reference = "r" + std::to_string(i);
    rows.push_back(grid_row("three", i + 1, reference, i < 3 ? 89.0 : 100.0));
    rows.push_back(grid_row("four", i + 1, reference, i < 4 ? 89.0 : 100.0));
    rows.push_back(grid_row("bound", i + 1, reference, 90.0));
  }
  rows.push_back(grid_row("three", 21, "r0", 0.0));
  rows.back().is_practice = true;
  QualityFlags flags;
  add_post_screening(numbered_sets(20), rows, flags);
  ASSERT_EQ(flags.participants.size(), 1u);
  ASSERT_EQ(flags.of_participant("four").size(), 1u);
  EXPECT_EQ(flags.of_participant("four")[0].rule, QualityRule::hidden_reference);
  EXPECT_EQ(flags.of_participant("four")[0].reason,
            "hidden reference rated below 90 in 4 of 20 trials (20 % > 15 %)");
  EXPECT_FALSE(flags.leaves_out("four"));
  flags.rules.post_screening = FlaggedAnswers::excluded;
  EXPECT_TRUE(flags.leaves_out("four"));
}

TEST(PostScreening, DoesNotCountAnchorsThatManyTakeForUnimpaired) {
  std::vector<AnswerRow> rows;
  for (int person = 0; person < 10; ++person)
    for (int i = 0; i < 5; ++i) {
      // Three of ten rate anchor 0 above 90, more than a quarter; one of them also anchor 1.
      const bool is_high = (i == 0 && person < 3) || (i == 1 && person == 0);
      rows.push_back(grid_row("p" + std::to_string(person), i + 1, "a" + std::to_string(i),
                              is_high ? 91.0 : 90.0));
    }
  QualityFlags flags;
  add_post_screening(numbered_sets(5), rows, flags);
  ASSERT_EQ(flags.participants.size(), 1u);
  ASSERT_EQ(flags.of_participant("p0").size(), 1u);
  EXPECT_EQ(flags.of_participant("p0")[0].reason,
            "anchor rated above 90 in 1 of 4 trials (25 % > 15 %)");
}

TEST(PostScreening, IsListedAndKeepsTheAnswersUnlessStatedOtherwise) {
  Manifest manifest = grid_study(6, 8);
  auto rows = answers_to(manifest, truth_by_level(manifest, clear_means), grid_people);
  for (AnswerRow& row : rows)
    if (row.participant == "p002" && row.stimulus == row.against) row.value = row.value_raw = "50";
  const AnswerSet kept = collect_answers(manifest, rows);
  EXPECT_EQ(kept.people.size(), 6u);
  const auto listed = listed_flags(kept, rows);
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].participant, "p002");
  EXPECT_FALSE(listed[0].is_excluded);
  const auto counts = rule_counts(kept, rows);
  ASSERT_EQ(counts.size(), 3u);  // reference, anchor, all together; there are no attention checks
  EXPECT_EQ(counts[0].rule, "hidden_reference");
  EXPECT_EQ(counts[0].bound, "90, 15 %");
  EXPECT_EQ(counts[0].participants, 1);
  EXPECT_EQ(counts[1].rule, "anchor");
  EXPECT_EQ(counts[1].participants, 0);
  manifest.questionnaire->analysis.quality.post_screening = FlaggedAnswers::excluded;
  EXPECT_EQ(collect_answers(manifest, rows).people.size(), 5u);
}

TEST(PostScreening, IsPartOfThePlanOfGridTrialsOnly) {
  const Manifest manifest = grid_study(6, 8);
  const std::string plan = quality_plan(*manifest.questionnaire);
  EXPECT_NE(plan.find("hidden reference below 90 in more than 15 % of the trials"),
            std::string::npos);
  EXPECT_NE(plan.find("anchor above 90"), std::string::npos);
  EXPECT_NE(plan.find("not left out"), std::string::npos);
  EXPECT_EQ(quality_plan(*two_emotion_study(4).questionnaire), "");
}

}  // namespace
}  // namespace mien::pipeline
