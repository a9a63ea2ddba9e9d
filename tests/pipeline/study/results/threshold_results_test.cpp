// Adaptive trials of simulated observers whose psychometric functions are known.

#include "pipeline/study/results/threshold_results.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/plot_texts.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/results/figures/result_figures.h"
#include "pipeline/study/results/report/page_tables.h"
#include "pipeline/study/results/result_tables.h"
#include "pipeline/study/thresholds/dose_study.h"

namespace mien::pipeline {
namespace {

using mien::test::adaptive_members;
using mien::test::dose_study;

std::vector<AnswerRow> answers_of(const Manifest& manifest, const SimulatedObservers& observers,
                                  int participants) {
  return simulated_sessions(manifest, plan_sessions(manifest, {}, participants), {},
                            {.attention_pass_rate = 1.0, .observers = observers});
}

ThresholdResults found_in(const Manifest& manifest, const std::vector<AnswerRow>& rows) {
  return threshold_results(collect_answers(manifest, rows));
}

TEST(ThresholdResults, FindTheStatedThresholdByQuest) {
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, trials: 60, tracks: 2"));
  const SimulatedObservers observers = {
      .threshold = 1.4, .threshold_deviation = 0.3, .width = 0.25, .lapse = 0.02};
  const auto rows = answers_of(manifest, observers, 24);
  const ThresholdResults found = found_in(manifest, rows);
  ASSERT_EQ(found.estimates.size(), 25u);
  EXPECT_FALSE(found.estimates[0].person);
  EXPECT_EQ(found.estimates[0].trials(), 24 * 120);
  EXPECT_EQ(found.tracks.size(), 48u);
  const GroupThreshold& fits = found.groups.at(0);
  EXPECT_EQ(fits.all, 24);
  EXPECT_GT(fits.people, 18);
  // Standard error of the mean: √(0.3² + error of a fit²)/√24, about 0.07.
  EXPECT_NEAR(fits.mean, 1.4, 0.25);
  EXPECT_LT(fits.ends.low, fits.mean);
  EXPECT_GT(fits.ends.high, fits.mean);
  EXPECT_NEAR(fits.deviation, 0.3, 0.2);
  EXPECT_EQ(std::string(found.groups.at(1).estimate), "quest");
  EXPECT_EQ(found.groups.at(1).people, 24) << "posterior distributions have a mean in any case";
  EXPECT_NEAR(found.groups.at(1).mean, 1.4, 0.25);
  for (const ThresholdEstimate& one : found.estimates) {
    if (!one.person || std::isnan(one.threshold)) continue;
    // Fit and posterior are about the same answers.
    EXPECT_NEAR(one.quest_mean, one.threshold, 0.4);
    EXPECT_LE(one.quest_ends.low, one.quest_mean);
    EXPECT_GE(one.quest_ends.high, one.quest_mean);
    EXPECT_TRUE(std::isnan(one.reversal_mean));
    if (one.fit.problem == FitProblem::step) {
      EXPECT_DOUBLE_EQ(2.0 * one.threshold, one.fit.step.low + one.fit.step.high);
      EXPECT_NE(threshold_remark(one).find("a step at a level, or between two"), std::string::npos);
      continue;
    }
    EXPECT_EQ(one.fit.function.guess, 0.5);
    EXPECT_GT(one.slope, 0.0);
    EXPECT_GT(one.deviance_p, 0.0);
    EXPECT_LE(one.deviance_p, 1.0);
  }
}

TEST(ThresholdResults, IntervalsOfParticipantsHoldTheirThreshold) {
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, trials: 150"));
  const SimulatedObservers observers = {
      .threshold = 1.5, .threshold_deviation = 0.0, .width = 0.3, .lapse = 0.0};
  const ThresholdResults found = found_in(manifest, answers_of(manifest, observers, 40));
  int held = 0, determined = 0;
  for (const ThresholdEstimate& one : found.estimates) {
    if (!one.person || std::isnan(one.threshold_ends.low) || std::isnan(one.threshold_ends.high))
      continue;
    ++determined;
    held += one.threshold_ends.low <= 1.5 && one.threshold_ends.high >= 1.5 ? 1 : 0;
  }
  EXPECT_GT(determined, 30);
  // Of 95 % intervals, fewer than 80 % would be too few with this number (p < 0.001 of the former).
  EXPECT_GT(held, 0.8 * determined);
}

TEST(ThresholdResults, FindTheStatedThresholdByStaircasesOfFallingLevels) {
  const Manifest manifest = dose_study(adaptive_members(
      "yes_no",
      "factor: dots, easier: falling, method: staircase, trials: 80, tracks: 2, noise: 0.3"));
  const SimulatedObservers observers = {
      .threshold = 34.0, .threshold_deviation = 2.0, .width = 4.0, .guess = 0.15, .lapse = 0.01};
  const ThresholdResults found = found_in(manifest, answers_of(manifest, observers, 12));
  EXPECT_NEAR(found.groups.at(0).mean, 34.0, 4.0);
  double reversals = 0.0, guesses = 0.0;
  int people = 0;
  for (const ThresholdEstimate& one : found.estimates) {
    if (!one.person) continue;
    ++people;
    reversals += one.reversal_mean;
    guesses += one.fit.function.guess;
    EXPECT_TRUE(std::isnan(one.quest_mean));
    // By level from the hardest: the references have 70 dots.
    EXPECT_EQ(one.counts.front().level, 70.0);
    EXPECT_TRUE(std::ranges::is_sorted(one.counts, std::ranges::greater{}, &LevelCount::level));
    EXPECT_LE(one.threshold_ends.low, one.threshold);
    EXPECT_GE(one.threshold_ends.high, one.threshold);
  }
  EXPECT_EQ(people, 12);
  // Two down, one up comes to 70.7 %, which is the default proportion.
  EXPECT_NEAR(reversals / people, 34.0, 4.0);
  EXPECT_NEAR(found.groups.at(1).mean, reversals / people, 1e-9);
  EXPECT_NEAR(guesses / people, 0.15, 0.08);
  EXPECT_EQ(found.tracks.size(), 24u);
  for (const TrackResult& track : found.tracks) {
    EXPECT_EQ(track.points.size(), 80u);
    EXPECT_EQ(track.reversals, std::ranges::count_if(track.points, &TrackPoint::is_reversal));
    EXPECT_GT(track.reversals, 4);
  }
}

TEST(ThresholdResults, ReversalsAreThoseOfAnswersByHand) {
  const Manifest manifest =
      dose_study(adaptive_members("yes_no", "factor: dose, method: staircase, down: 1, trials: 7"));
  std::vector<AnswerRow> rows = answers_of(manifest, {}, 1);
  // Levels 3, 2.5, 2, 2.5, 2, 2.5, 2: reversals at the answers to 2, 2.5, 2, 2.5.
  const char* levels[] = {"3", "2.5", "2", "2.5", "2", "2.5", "2"};
  const char* given[] = {"yes", "yes", "no", "yes", "no", "yes", "no"};
  std::size_t next = 0;
  for (AnswerRow& row : rows) {
    if (!row.track) continue;
    row.level = levels[next];
    row.stimulus = "a" + std::to_string(std::lround(2.0 * std::stod(levels[next])));
    row.value = row.value_raw = given[next++];
  }
  const ThresholdResults found = found_in(manifest, rows);
  ASSERT_EQ(found.tracks.size(), 1u);
  std::vector<bool> reversals;
  for (const TrackPoint& point : found.tracks[0].points) reversals.push_back(point.is_reversal);
  EXPECT_EQ(reversals, (std::vector<bool>{false, false, true, true, true, true, true}));
  EXPECT_EQ(found.tracks[0].reversals, 5);
  // Of five, the first two and one more are left out: 2.5 and 2.
  EXPECT_DOUBLE_EQ(found.tracks[0].reversal_mean, 2.25);
}

TEST(ThresholdResults, RulesOfQualityLeaveAnswersOutOfFitsButNotOfTracks) {
  Manifest manifest =
      dose_study(adaptive_members("same_different", "factor: dose, trials: 40, method: staircase"));
  auto rows = answers_of(manifest, {}, 4);
  const ThresholdResults all = found_in(manifest, rows);
  for (std::size_t i = 0; i < rows.size(); i += 4) rows[i].rt_ms = 1.0;
  manifest.questionnaire->analysis.quality.min_rt_ms = 100.0;
  const ThresholdResults some = found_in(manifest, rows);
  EXPECT_EQ(all.estimates[0].trials(), static_cast<int>(rows.size()));
  EXPECT_EQ(some.estimates[0].trials(), static_cast<int>(rows.size() - (rows.size() + 3) / 4));
  ASSERT_EQ(some.tracks.size(), all.tracks.size());
  for (std::size_t i = 0; i < all.tracks.size(); ++i) {
    EXPECT_EQ(some.tracks[i].points.size(), all.tracks[i].points.size());
    EXPECT_EQ(some.tracks[i].reversals, all.tracks[i].reversals);
  }
}

TEST(ThresholdResults, RefuseLevelsThatAreNotThoseOfTheStimuli) {
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, trials: 10"));
  const auto rows = answers_of(manifest, {}, 2);
  const auto fault_of = [&](auto&& change) {
    std::vector<AnswerRow> changed = rows;
    change(changed[3]);
    try {
      collect_answers(manifest, changed);
    } catch (const Faults& faults) {
      return std::string(faults.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault_of([](AnswerRow&) {}), "");
  EXPECT_NE(
      fault_of([](AnswerRow& row) { row.level = "7"; }).find("the level \"7\" is not that of"),
      std::string::npos);
  EXPECT_NE(fault_of([](AnswerRow& row) { row.level.clear(); }).find("the level \"\" is not that"),
            std::string::npos);
  EXPECT_NE(fault_of([](AnswerRow& row) { row.value = "b5x"; }).find("is no answer to this trial"),
            std::string::npos);
}

TEST(ThresholdResults, SayWhyThereIsNoThreshold) {
  const Manifest manifest = dose_study(adaptive_members("yes_no", "factor: dose, trials: 10"));
  auto rows = answers_of(manifest, {}, 2);
  for (AnswerRow& row : rows)
    if (row.participant == "p001") row.value = row.value_raw = "yes";
  const ThresholdResults found = found_in(manifest, rows);
  EXPECT_EQ(threshold_remark(found.estimates.at(1)), "all answers are positive");
  EXPECT_TRUE(std::isnan(found.estimates.at(1).threshold));
  EXPECT_LT(found.groups.at(0).people, 2);
  EXPECT_EQ(found.groups.at(0).all, 2);
  EXPECT_TRUE(std::isnan(found.groups.at(0).mean));
}

TEST(ThresholdResults, HaveTablesFiguresAndASectionThatSayThatTheyAreSimulated) {
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, trials: 40, tracks: 2"));
  const auto rows = answers_of(manifest, {.threshold = 1.5, .width = 0.3}, 3);
  const Results results = results_of(collect_answers(manifest, rows), rows, {});
  EXPECT_TRUE(results.detection.rows.empty()) << "no d′ of levels that differ";
  std::vector<std::string> names;
  for (const WrittenTable& table : result_tables(results)) {
    const std::string path(table.form.path);
    if (path.find("thresh") == std::string::npos && path.find("track") == std::string::npos)
      continue;
    names.push_back(path);
    EXPECT_NE(table.csv.find(",simulated\n"), std::string::npos) << path;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"results/thresholds.csv", "results/threshold_levels.csv",
                                      "results/tracks.csv", "results/track_trials.csv",
                                      "results/mean_threshold.csv"}));
  std::vector<std::string> drawn;
  for (const ResultFigure& figure : result_figures(results)) {
    if (figure.section != "thresholds") continue;
    drawn.push_back(figure.name);
    const auto texts = mien::test::texts_of(figure.plot);
    EXPECT_TRUE(std::ranges::any_of(
        texts, [](const DrawnText& one) { return one.text == simulated_ratings_mark; }));
  }
  EXPECT_EQ(drawn, (std::vector<std::string>{"proportions-by-level", "tracks",
                                             "thresholds-by-participant"}));
  const std::string html = threshold_section_html(results, "");
  EXPECT_NE(html.find("QUEST+, Watson 2017"), std::string::npos);
  EXPECT_NE(html.find("75 % of positive answers"), std::string::npos) << html;
  EXPECT_NE(html.find("all answers"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
