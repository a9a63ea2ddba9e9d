// The power of planned tests against closed forms, mixed models in R, and the report's own
// analysis.

#include "pipeline/study/power/planned_power.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/study/power/design_size.h"
#include "pipeline/study/power/planned_design.h"
#include "pipeline/study/power/power_output.h"
#include "pipeline/study/power/scale_tests.h"
#include "pipeline/study/questionnaire/paired_t_power.h"
#include "pipeline/study/results/factor_contrasts.h"
#include "pipeline/study/results/factor_effects.h"

namespace mien::pipeline {
namespace {

using test::paired_t_power;

/// Two ways of making × so many emotions × takes, all seen by every participant.
Manifest planned_study(int emotions, int takes, int participants = 16) {
  constexpr const char* names[] = {"sad", "happy", "angry"};
  Manifest manifest;
  manifest.study = "planned";
  manifest.seed = 5;
  for (const char* made : {"acted", "modified"}) {
    for (int emotion = 0; emotion < emotions; ++emotion) {
      for (int take = 1; take <= takes; ++take) {
        Stimulus stimulus;
        stimulus.id = fmt::format("{}-{}-{}", made, names[emotion], take);
        stimulus.factors = {{"made", made}, {"take", std::to_string(take)}};
        if (emotions > 1) stimulus.factors.emplace_back("emotion", names[emotion]);
        manifest.stimuli.push_back(stimulus);
      }
    }
  }
  Questionnaire asked;
  asked.participants = participants;
  asked.scales.ids = {"sad-happy"};
  asked.answer.slider = true;
  asked.analysis.factorial.factors = {"made"};
  if (emotions > 1) asked.analysis.factorial.factors.emplace_back("emotion");
  manifest.questionnaire = asked;
  return manifest;
}

PlannedContrast acted_against_modified() {
  PlannedContrast contrast;
  contrast.name = "acted against modified";
  contrast.weights = {{"made", {{"acted", 1.0}, {"modified", -1.0}}}};
  return contrast;
}

PlannedPowerOptions options_of(const RatingSpread& spread, double difference,
                               std::vector<int> participants, int studies = 2000) {
  PlannedPowerOptions options;
  options.spreads = {{"", spread}};
  options.difference = difference;
  options.participants = std::move(participants);
  options.studies = studies;
  return options;
}

const PlannedTestPower& row_of(const std::vector<PlannedTestPower>& rows, const char* name,
                               TestedBy by, int participants, int per_cell = -1) {
  const auto found = std::ranges::find_if(rows, [&](const PlannedTestPower& row) {
    return row.name == name && row.by == by && row.participants == participants &&
           (per_cell < 0 || row.stimuli_per_cell == per_cell);
  });
  if (found == rows.end()) throw Error(std::string("no row of ") + name, "simulate it");
  return *found;
}

TEST(PlannedPower, OfAContrastIsThatOfTheNoncentralDistribution) {
  Manifest manifest = planned_study(1, 4);
  manifest.questionnaire->analysis.factorial.contrasts = {acted_against_modified()};
  const RatingSpread spread = {.participant = 1.0, .stimulus = 0.0, .residual = 1.2};
  const auto rows = planned_power(manifest, options_of(spread, 0.5, {12, 24}, 4000));
  for (const int people : {12, 24}) {
    // Four ratings less four ratings.
    const double expected = paired_t_power(people, 0.5, std::sqrt(2.0 / 4.0) * 1.2, 0.05);
    for (const char* name : {"acted against modified", "made"}) {
      const PlannedTestPower& row = row_of(rows, name, TestedBy::participants, people);
      EXPECT_NEAR(row.power.share, expected, 0.028) << name;  // 3.5 standard errors
      EXPECT_NEAR(row.power_error, std::sqrt(expected * (1.0 - expected) / 4000.0), 5e-4);
      EXPECT_NEAR(row.false_positives.share, 0.05, 0.0125) << name;
      EXPECT_EQ(row.people, people);
      EXPECT_EQ(row.assumed, 0.5);
    }
  }
}

TEST(PlannedPower, IsPrintedWithItsInterval) {
  PlannedTestPower row;
  row.name = "made";
  row.scale = "sad-happy";
  row.participants = 12;
  row.studies = 400;
  row.power = {.share = 0.712, .low = 0.6651, .high = 0.7549};
  row.power_error = 0.0226;
  row.false_positives = {.share = 0.05, .low = 0.03, .high = 0.055};
  EXPECT_EQ(planned_power_lines({row}, 12, 0.8, 0.05).back(),
            "  participants random: 71.2 [66.5, 75.5] (false positives 5.0); below 80 % up to 12 "
            "participants");
  EXPECT_EQ(planned_power_notes({row}, 12, 0.05).front(),
            "In brackets: 95 % interval of the simulation (Wilson).");
}

/// Table, text and figure list tests in the same order.
TEST(PlannedPower, IsListedWithContrastsFirst) {
  Manifest manifest = planned_study(2, 2);
  manifest.questionnaire->analysis.factorial.contrasts = {acted_against_modified()};
  const auto rows = planned_power(manifest, options_of({}, 0.5, {12}, 100));
  std::vector<std::string> lines;
  for (const std::string& line : planned_power_lines(rows, 12, 0.8, 0.05))
    if (!line.starts_with(" ")) lines.push_back(line);
  EXPECT_EQ(lines,
            (std::vector<std::string>{"acted against modified (planned contrast, sad-happy)",
                                      "made (effect, sad-happy)", "emotion (effect, sad-happy)",
                                      "made × emotion (effect, sad-happy)"}));
  const Plot chart = power_chart("planned", rows, 0.8);
  const auto canvas = Canvas::svg(chart.width, chart.height);
  chart.draw(*canvas);
  std::vector<std::string> panels;
  for (const DrawnText& text : canvas->texts())
    for (const char* name : {"acted against modified", "made", "emotion", "made × emotion"})
      if (text.text == name) panels.push_back(text.text);
  EXPECT_EQ(panels, (std::vector<std::string>{"acted against modified", "made", "emotion",
                                              "made × emotion"}));
}

/// Four sets of an acted and a modified stimulus, of which each participant sees so many.
Manifest planned_grids(int sets_each) {
  Manifest manifest = planned_study(1, 4);
  manifest.questionnaire->trials = &grid_form;
  manifest.questionnaire->grid.alike = {"take"};
  manifest.questionnaire->per_participant = sets_each;
  return manifest;
}

TEST(PlannedPower, OfGridsIsThatOfRatingsOfWholeSets) {
  const RatingSpread spread = {.participant = 1.0, .stimulus = 0.0, .residual = 1.2};
  for (const int sets : {2, 4}) {
    const auto rows = planned_power(planned_grids(sets), options_of(spread, 0.6, {20}, 4000));
    const PlannedTestPower& row = row_of(rows, "made", TestedBy::participants, 20);
    EXPECT_EQ(row.people, 20);
    EXPECT_EQ(row.stimuli_per_cell, 4);
    EXPECT_NEAR(row.power.share, paired_t_power(20, 0.6, std::sqrt(2.0 / sets) * 1.2, 0.05), 0.028);
  }
}

TEST(PlannedPower, OfMoreGridsHasMoreSets) {
  const Manifest grids = planned_grids(0);
  const Manifest more = with_stimuli_per_cell(grids, 7);
  ASSERT_EQ(grid_sets(more).size(), 7u);
  for (const GridSet& set : grid_sets(more)) EXPECT_EQ(set.stimuli.size(), 2u);
  Manifest listed = grids;
  listed.questionnaire->grid = {.sets = {{"acted-sad-1", "modified-sad-1"}}};
  EXPECT_THROW(with_stimuli_per_cell(listed, 2), Error);
  Manifest by_way = grids;
  by_way.questionnaire->grid.alike = {"made"};
  EXPECT_EQ(grid_sets(with_stimuli_per_cell(by_way, 12))[0].stimuli.size(), 12u);
  EXPECT_THROW(with_stimuli_per_cell(by_way, 13), Error);
}

TEST(PlannedPower, TellsWhatIsAssumed) {
  Manifest manifest = planned_study(1, 4);
  const PlannedPowerOptions options =
      options_of({.participant = 1.0, .stimulus = 0.25, .residual = 1.2}, 0.6, {20}, 300);
  const std::vector<std::string> told = power_assumptions(manifest, options);
  ASSERT_EQ(told.size(), 3u);
  EXPECT_NE(told[0].find("0.6 points in one test at a time"), std::string::npos);
  EXPECT_NE(told[1].find("participants 1, stimuli 0.25, participants in cells 0, residual 1.2"),
            std::string::npos);
  EXPECT_EQ(
      told[2],
      "300 simulated studies of each size. Tests with α = 0.05; p values corrected within the "
      "effects and within the planned contrasts (Holm).");
  const Plot chart = power_chart("planned", planned_power(manifest, options), 0.8, told);
  const auto canvas = Canvas::svg(chart.width, chart.height);
  chart.draw(*canvas);
  std::string below;
  for (const DrawnText& drawn : canvas->texts()) {
    EXPECT_LE(drawn.box.bottom(), chart.height) << drawn.text;
    EXPECT_LE(canvas->text_width(drawn.text, {.size = 8.0}), chart.width - 48.0) << "is cut short";
    below += drawn.text + " ";
  }
  for (const std::string& sentence : told) EXPECT_NE(below.find(sentence), std::string::npos);
}

TEST(PlannedPower, WithoutAnyEffectIsTheLevel) {
  Manifest manifest = planned_study(3, 4);
  manifest.questionnaire->analysis.correction = TestCorrection::none;
  PlannedPowerOptions options =
      options_of({.participant = 0.5, .stimulus = 0.6, .residual = 0.8}, 0.5, {20}, 3000);
  options.truth = StatedTruth{};
  const auto rows = planned_power(manifest, options);
  for (const char* name : {"made", "emotion", "made × emotion"}) {
    const auto& both = row_of(rows, name, TestedBy::participants_and_stimuli, 20);
    EXPECT_NEAR(both.power.share, 0.05, 0.015) << name;
    EXPECT_EQ(both.power.share, both.false_positives.share) << name;
    // Over participants alone, differences between stimuli are taken for effects.
    EXPECT_GT(row_of(rows, name, TestedBy::participants, 20).false_positives.low, 0.15) << name;
  }
}

TEST(PlannedPower, OfCorrectedTestsCountsTheWholeFamily) {
  Manifest manifest = planned_study(3, 2);
  PlannedPowerOptions options =
      options_of({.participant = 0.5, .stimulus = 0.0, .residual = 1.0}, 0.5, {20});
  options.truth = StatedTruth{};
  const auto with_holm = planned_power(manifest, options);
  manifest.questionnaire->analysis.correction = TestCorrection::none;
  const auto without = planned_power(manifest, options);
  double corrected = 0.0, uncorrected = 0.0;
  for (const char* name : {"made", "emotion", "made × emotion"}) {
    corrected += row_of(with_holm, name, TestedBy::participants, 20).power.share;
    uncorrected += row_of(without, name, TestedBy::participants, 20).power.share;
  }
  EXPECT_LT(corrected, 0.065);
  EXPECT_GT(uncorrected, 0.12);
}

TEST(PlannedPower, IsThatOfMixedModelsInR) {
  // reference/power.R: 541 and 702 of 1000 studies.
  constexpr double r_intercepts = 0.541, r_slopes = 0.702;
  const auto by_intercepts = planned_power(
      planned_study(1, 6),
      options_of({.participant = 0.5, .stimulus = 0.5, .residual = 0.8}, 0.7, {16}, 4000));
  const auto& intercepts = row_of(by_intercepts, "made", TestedBy::participants_and_stimuli, 16);
  Manifest with_slopes = planned_study(1, 8);
  with_slopes.questionnaire->analysis.factorial.random_slopes = true;
  const auto by_slopes = planned_power(
      with_slopes,
      options_of({.participant = 0.5, .stimulus = 0.4, .residual = 0.8, .participant_by_cell = 0.5},
                 0.7, {20}, 4000));
  const auto& slopes = row_of(by_slopes, "made", TestedBy::participants_and_stimuli, 20);
  const auto error = [](double share) {
    return std::sqrt(share * (1.0 - share) * (1.0 / 1000.0 + 1.0 / 4000.0));
  };
  EXPECT_NEAR(intercepts.power.share, r_intercepts, 3.5 * error(r_intercepts));
  EXPECT_NEAR(slopes.power.share, r_slopes, 3.5 * error(r_slopes));
}

TEST(PlannedPower, RisesWithStimuliWhereTheyDiffer) {
  PlannedPowerOptions options =
      options_of({.participant = 0.5, .stimulus = 0.8, .residual = 0.5}, 1.0, {10, 40}, 1000);
  options.stimuli_per_cell = {2, 4, 12};
  const auto rows = planned_power(planned_study(1, 4), options);
  const auto power = [&](int participants, int per_cell) {
    return row_of(rows, "made", TestedBy::participants_and_stimuli, participants, per_cell)
        .power.share;
  };
  EXPECT_GT(power(10, 4), power(10, 2) + 0.05);
  EXPECT_GT(power(10, 12), power(10, 4) + 0.2);
  // Four times as many participants help less than three times as many stimuli.
  EXPECT_LT(power(40, 4), power(10, 12) - 0.1);
}

TEST(PlannedPower, OfGroupsFollowsTheirSizes) {
  Manifest manifest = planned_study(1, 2);
  manifest.questionnaire->demographics = {{.id = "gender"}};
  manifest.questionnaire->analysis.factorial.between = "gender";
  manifest.questionnaire->analysis.correction = TestCorrection::none;
  PlannedPowerOptions options =
      options_of({.participant = 0.5, .stimulus = 0.0, .residual = 0.8}, 0.6, {40}, 1000);
  const auto equal = planned_power(manifest, options);
  options.groups = {0.9, 0.1};
  const auto unequal = planned_power(manifest, options);
  EXPECT_GT(row_of(equal, "gender", TestedBy::participants, 40).power.share,
            row_of(unequal, "gender", TestedBy::participants, 40).power.share + 0.15);
  EXPECT_NEAR(row_of(unequal, "gender", TestedBy::participants, 40).false_positives.share, 0.05,
              0.025);
  EXPECT_GT(row_of(equal, "gender × made", TestedBy::participants, 40).power.share, 0.1);
}

TEST(PlannedPower, DependsOnTheSeedAndNotOnOtherSizes) {
  const RatingSpread spread = {.participant = 0.5, .stimulus = 0.5, .residual = 0.8};
  const Manifest manifest = planned_study(1, 3);
  const auto some = planned_power(manifest, options_of(spread, 0.5, {10}, 300));
  const auto more = planned_power(manifest, options_of(spread, 0.5, {10, 30}, 300));
  EXPECT_EQ(row_of(some, "made", TestedBy::participants, 10).power.share,
            row_of(more, "made", TestedBy::participants, 10).power.share);
  PlannedPowerOptions other = options_of(spread, 0.5, {10}, 300);
  other.seed = 1;
  EXPECT_NE(row_of(some, "made", TestedBy::participants, 10).power.share,
            row_of(planned_power(manifest, other), "made", TestedBy::participants, 10).power.share);
}

TEST(PlannedPower, RefusesStudiesWithoutPlannedTests) {
  Manifest manifest = planned_study(1, 2);
  manifest.questionnaire->stimuli.levels = {{"made", {"acted"}}};
  EXPECT_THROW(planned_power(manifest, options_of({}, 0.5, {10}, 100)), Error);
  Manifest words = planned_study(1, 2);
  words.questionnaire->answer.words = true;
  EXPECT_THROW(planned_power(words, options_of({}, 0.5, {10}, 100)), Error);
  PlannedPowerOptions huge = options_of({}, 0.5, {10000}, 1000000);
  EXPECT_THROW(planned_power(planned_study(3, 4), huge), Error);
}

/// Ratings of a study as the report reads them, and as the simulation tests them.
TEST(ScaleTests, AreThoseOfTheReport) {
  Manifest manifest = planned_study(3, 2, 14);
  FactorialPlan& plan = manifest.questionnaire->analysis.factorial;
  plan.contrasts = {acted_against_modified()};
  plan.contrasts[0].at = {{"emotion", "sad"}};
  manifest.questionnaire->per_participant = 7;
  const PlannedDesign design = planned_design(manifest, 14, {});
  Eigen::MatrixXd ratings =
      Eigen::MatrixXd::Constant(14, static_cast<Eigen::Index>(design.stimuli.size()), std::nan(""));
  AnswerSet answers;
  answers.scales = questionnaire_scales(manifest).scales;
  answers.factors = design_table(manifest);
  answers.factorial = plan;
  for (const Stimulus& stimulus : manifest.stimuli) answers.stimuli.push_back({.id = stimulus.id});
  for (std::size_t person = 0; person < 14; ++person) {
    answers.people.push_back(std::to_string(person));
    for (const std::size_t stimulus : design.shares[person]) {
      const double rating =
          std::round(10.0 * normal_number(3, 100 * person + stimulus)) / 10.0 + 0.1 * stimulus;
      ratings(static_cast<Eigen::Index>(person), static_cast<Eigen::Index>(stimulus)) = rating;
      answers.ratings.push_back({person, stimulus, 0, rating});
    }
  }
  const Eigen::MatrixXd none =
      Eigen::MatrixXd::Zero(1, static_cast<Eigen::Index>(design.stimuli.size()));
  const ScaleTests tests(design, 0, ratings, RandomParticipants::intercepts);
  const std::vector<TestedTwice> found = tests.tests(none);
  const FactorEffects effects = factor_effects(answers, {});
  ASSERT_EQ(found.size(), 4u);
  ASSERT_EQ(effects.scales[0].effects.size(), 3u);
  EXPECT_EQ(tests.people(), effects.scales[0].people);
  EXPECT_LT(tests.people(), 14);  // some saw none of a cell
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(design.effects[i], effects.scales[0].effects[i].name);
    EXPECT_NEAR(found[i].by_participants, effects.scales[0].effects[i].test.p_corrected, 1e-9);
    EXPECT_TRUE(std::isnan(found[i].by_both));
  }
  EXPECT_NEAR(found[3].by_participants, factor_contrasts(answers)[0].within.t.p, 1e-9);
}

TEST(StudySize, CopiesStimuliOrTakesTheFirst) {
  const Manifest manifest = planned_study(3, 4);
  EXPECT_EQ(stimuli_per_cell(manifest), 4);
  const Manifest fewer = with_stimuli_per_cell(manifest, 3);
  EXPECT_EQ(stimuli_per_cell(fewer), 3);
  const std::vector<std::string> kept = questionnaire_stimuli(fewer);
  EXPECT_EQ(std::ranges::count_if(kept, [](auto& id) { return id.ends_with("-4"); }), 0);
  const Manifest more = with_stimuli_per_cell(manifest, 9);
  EXPECT_EQ(stimuli_per_cell(more), 9);
  EXPECT_EQ(questionnaire_stimuli(more).size(), 54u);
  EXPECT_EQ(level_of(more, "acted-sad-1~3", "made"), "acted");
  EXPECT_EQ(level_of(more, "acted-sad-1~3", "take"), "1~3");
  Manifest uneven = manifest;
  uneven.stimuli.pop_back();
  EXPECT_EQ(stimuli_per_cell(uneven), 0);
  EXPECT_EQ(stimuli_per_cell(with_stimuli_per_cell(uneven, 5)), 5);
}

TEST(StudySize, KeepsLevelsThatFollowFromHowAStimulusIsMade) {
  Manifest manifest = planned_study(1, 2);
  for (Stimulus& stimulus : manifest.stimuli) {
    stimulus.sound = StimulusSound{};
    stimulus.sound->of = stimulus.id.ends_with("1") ? stimulus.id : "another";
  }
  manifest.questionnaire->analysis.factorial.factors = {"made", "audio"};
  ASSERT_EQ(level_of(manifest, "acted-sad-1", "audio"), "matched");
  ASSERT_EQ(level_of(manifest, "acted-sad-2", "audio"), "mismatched");
  const Manifest more = with_stimuli_per_cell(manifest, 3);
  EXPECT_EQ(level_of(more, "acted-sad-1~3", "audio"), "matched");
  EXPECT_EQ(level_of(more, "acted-sad-2~2", "audio"), "mismatched");
}

/// Acted and modified motions of the same take are compared.
Manifest planned_pairs(int takes, int participants = 20) {
  Manifest manifest = planned_study(1, takes, participants);
  manifest.questionnaire->trials = &pair_form;
  manifest.questionnaire->preference.alike = {"take"};
  manifest.questionnaire->analysis.factorial.contrasts = {acted_against_modified()};
  return manifest;
}

TEST(PlannedPower, OfPairsIsTheLevelOrRisesWithTheEffect) {
  PlannedPowerOptions options =
      options_of({.participant = 0.5, .stimulus = 0.0, .residual = 0.8}, 0.4, {12, 30}, 400);
  const auto rows = planned_power(planned_pairs(6), options);
  ASSERT_EQ(rows.size(), 2u);  // no test with random stimuli
  EXPECT_EQ(rows[0].name, "acted against modified");
  for (const PlannedTestPower& row : rows) EXPECT_NEAR(row.false_positives.share, 0.05, 0.04);
  EXPECT_GT(rows[1].power.share, rows[0].power.share + 0.2);
  options.truth =
      StatedTruth{{{"acted-sad-1", "sad-happy"}, 0.6}, {{"acted-sad-2", "sad-happy"}, 0.6}};
  options.participants = {30};
  const auto by_truth = planned_power(planned_pairs(6), options);  // a mean of 0.2 in the cell
  EXPECT_LT(by_truth[0].power.share, rows[1].power.share - 0.1);
  EXPECT_GT(by_truth[0].power.share, 0.1);
  options.stimuli_per_cell = {12};
  EXPECT_GT(planned_power(planned_pairs(6), options)[0].power.share, by_truth[0].power.share + 0.1);
}

TEST(PlannedPower, SaysThatItIsSimulatedAndWhereATestIsNotValid) {
  Manifest manifest = planned_study(1, 4);
  PlannedPowerOptions options =
      options_of({.participant = 0.5, .stimulus = 0.8, .residual = 0.5}, 1.5, {10, 20}, 300);
  options.stimuli_per_cell = {4, 8};
  const auto rows = planned_power(manifest, options);
  const WrittenTable table = power_table(rows);
  const CsvTable read = parse_csv(table.csv, "power.csv");
  EXPECT_EQ(read.rows.size(), 8u);
  for (const auto& row : read.rows)
    EXPECT_EQ(row[static_cast<std::size_t>(find_column(read, "simulated"))].text, "1");
  int inflated = 0, valid = 0;
  for (const std::string& sentence : planned_power_lines(rows, 20, 0.8, 0.05)) {
    inflated += sentence.find("valid for these stimuli only") != std::string::npos;
    valid += sentence.find("participants and stimuli random") != std::string::npos &&
             sentence.find("80 %") != std::string::npos;
  }
  EXPECT_EQ(inflated, 2);
  EXPECT_EQ(valid, 2);
  const auto notes = planned_power_notes(rows, 20, 0.05);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_NE(notes[1].find("with α = 0.05 and not corrected for multiple"), std::string::npos);
  EXPECT_NE(notes[2].find("does not control for stimuli"), std::string::npos);
  EXPECT_NE(notes[2].find("hence no number of participants is given"), std::string::npos);
  options.spreads.front().spread.stimulus = 0.0;  // these particular stimuli
  EXPECT_EQ(planned_power_notes(planned_power(manifest, options), 20, 0.05).size(), 2u);
  options.spreads.front().spread.stimulus = 0.8;
  manifest.questionnaire->per_participant = 1;  // of eight, so that nobody sees both cells
  options.stimuli_per_cell.clear();
  const auto impossible = planned_power_lines(planned_power(manifest, options), 20, 0.8, 0.05);
  EXPECT_EQ(impossible.back(),
            "  4 stimuli per cell, participants random: not possible, because too few participants "
            "rate every cell");
  const Plot chart = power_chart("planned", rows, 0.8);
  const auto canvas = Canvas::svg(chart.width, chart.height);
  chart.draw(*canvas);
  const auto has_text = [&](const std::string& text) {
    return std::ranges::any_of(canvas->texts(), [&](const DrawnText& drawn) {
      return drawn.text.find(text) != std::string::npos;
    });
  };
  EXPECT_TRUE(has_text("Simulated studies"));
  EXPECT_TRUE(has_text("8 stimuli per cell"));
  EXPECT_TRUE(has_text("participants and stimuli random"));
  for (const DrawnText& text : canvas->texts()) {
    EXPECT_GE(text.box.x, 0.0) << text.text;
    EXPECT_LE(text.box.right(), chart.width) << text.text;
    EXPECT_LE(text.box.bottom(), chart.height) << text.text;
  }
}

}  // namespace
}  // namespace mien::pipeline
