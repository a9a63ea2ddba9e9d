#include "pipeline/study/questionnaire/adaptive_part.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/session_duration.h"
#include "pipeline/study/questionnaire/session_plan.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/thresholds/dose_study.h"

namespace mien::pipeline {
namespace {

using mien::test::adaptive_members;
using mien::test::dose_study;
using Names = std::vector<std::string>;

std::vector<Trial> part_of(const std::string& form, const std::string& more,
                           std::uint64_t seed = 3) {
  return adaptive_part(dose_study(adaptive_members(form, "factor: dose, " + more)), seed);
}

TEST(AdaptivePart, HasEachTrackOnceInARound) {
  const std::vector<Trial> trials = part_of("two_interval", "trials: 20, tracks: 3");
  ASSERT_EQ(trials.size(), 60u);
  std::set<std::vector<int>> orders;
  for (std::size_t round = 0; round < 20; ++round) {
    std::vector<int> order;
    for (std::size_t i = 0; i < 3; ++i) order.push_back(trials[3 * round + i].adaptive.track);
    orders.insert(order);
    std::ranges::sort(order);
    EXPECT_EQ(order, (std::vector{1, 2, 3}));
  }
  EXPECT_GT(orders.size(), 3u) << "in random order";
}

TEST(AdaptivePart, ShowsTheSignalFirstInOneOfTwoTrialsOfATrack) {
  std::map<int, std::vector<std::string>> answers;
  for (const Trial& trial : part_of("two_interval", "trials: 20, tracks: 2")) {
    answers[trial.adaptive.track].push_back(trial.adaptive.positive);
    for (std::size_t place = 0; place < 6; ++place) {
      const Names& shown = trial.adaptive.by_level.at(place);
      ASSERT_EQ(shown.size(), 2u);
      const bool is_first = trial.adaptive.positive == "first";
      const std::string& signal = shown[is_first ? 0 : 1];
      const std::string& reference = shown[is_first ? 1 : 0];
      EXPECT_EQ(signal.substr(1), std::to_string(place + 1)) << "of its level";
      EXPECT_EQ(reference, signal.substr(0, 1) + "0") << "the neutral stimulus of the same actor";
    }
  }
  std::set<std::string> pairs;
  for (const auto& [track, given] : answers) {
    ASSERT_EQ(given.size(), 20u);
    for (std::size_t i = 0; i < given.size(); i += 2) {
      EXPECT_NE(given[i], given[i + 1]);
      pairs.insert(given[i]);
    }
  }
  EXPECT_EQ(pairs.size(), 2u) << "which one comes first is random";
}

TEST(AdaptivePart, DrawsTheStimuliOfALevelEquallyOften) {
  std::map<std::string, int> shown;
  for (const Trial& trial : part_of("yes_no", "trials: 30, noise: 0.25"))
    if (trial.is_adaptive()) ++shown[trial.adaptive.by_level.at(2).at(0)];
  EXPECT_EQ(shown, (std::map<std::string, int>{{"a3", 15}, {"b3", 15}}));
}

TEST(AdaptivePart, HasTheStatedShareWithoutTheSignalAtRandomPlaces) {
  std::set<std::vector<bool>> orders;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    std::map<std::string, int> shown;
    std::vector<bool> order;
    for (const Trial& trial : part_of("same_different", "trials: 30, noise: 0.25", seed)) {
      order.push_back(trial.is_adaptive());
      EXPECT_EQ(trial.adaptive.positive, "different");
      if (trial.is_adaptive()) continue;
      ASSERT_EQ(trial.stimuli.size(), 2u);
      EXPECT_EQ(trial.stimuli[0], trial.stimuli[1]);
      EXPECT_EQ(trial.level, "0");
      ++shown[trial.stimuli[0]];
    }
    EXPECT_EQ(order.size(), 40u);
    EXPECT_EQ(shown, (std::map<std::string, int>{{"a0", 5}, {"b0", 5}}));
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 8u);
}

TEST(AdaptivePart, DependsOnTheSeedAlone) {
  const auto one = part_of("two_interval", "trials: 20, tracks: 2");
  EXPECT_EQ(one, part_of("two_interval", "trials: 20, tracks: 2"));
  EXPECT_NE(one, part_of("two_interval", "trials: 20, tracks: 2", 4));
}

TEST(AdaptivePart, IsShownAtALevel) {
  const std::vector<Trial> trials = part_of("yes_no", "trials: 20");
  const auto trial = std::ranges::find_if(trials, &Trial::is_adaptive);
  const Trial shown = shown_at(*trial, 4, {"0.5", "1", "1.5", "2", "2.5", "3"});
  EXPECT_EQ(shown.level, "2.5");
  EXPECT_EQ(shown.stimuli, trial->adaptive.by_level[4]);
  EXPECT_TRUE(trial->stimuli.empty()) << "unknown in the plan";
}

TEST(AdaptivePlans, HaveNumbersItemsChecksAndADuration) {
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, trials: 20") +
                 ", practice: [a0, a6], attention: {every: 8}");
  const std::vector<SessionPlan> plans = plan_sessions(manifest);
  ASSERT_EQ(plans.size(), 3u);
  EXPECT_EQ(plans, plan_sessions(manifest));
  EXPECT_NE(plans[0].trials, plans[1].trials);
  for (const SessionPlan& plan : plans) {
    EXPECT_TRUE(plan.trials.front().practice);
    EXPECT_EQ(std::ranges::count_if(plan.trials, &Trial::is_adaptive), 20);
    EXPECT_EQ(std::ranges::count_if(plan.trials, &Trial::is_attention_check), 2);
    for (std::size_t i = 0; i < plan.trials.size(); ++i) {
      EXPECT_EQ(plan.trials[i].number, static_cast<int>(i) + 1);
      ASSERT_EQ(plan.trials[i].items.size(), 1u);
      EXPECT_EQ(plan.trials[i].items[0].item, "two_interval");
    }
  }
  // Two films of 4 s, half a second between them, an answer and a pause for each of 21 trials; two
  // checks.
  EXPECT_NEAR(plans[0].expected_seconds, 21 * (8.5 + 3.5 + 1.5) + 2 * (3.5 + 1.5), 1e-9);
  EXPECT_NE(plans_csv(plans).find(",track\n"), std::string::npos);
  const std::string csv = plans_csv(plans);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 23);
  EXPECT_EQ(balance_csv(balance_of(manifest, plans)).find("\nseen"), std::string::npos);
}

TEST(AdaptivePlans, OfOtherStudiesKeepTheirHash) {
  // The column `track` of plans came later; without adaptive trials nothing else has changed.
  const Manifest manifest =
      dose_study("participants: 3, question: Which one, trials: yes_no, signal: {actor: [a]}");
  EXPECT_EQ(design_hash(manifest, plan_sessions(manifest)), "14235a836910b00104dc69f9a02f030d");
}

TEST(AdaptivePlans, ChangeTheHashWithTheRule) {
  const auto hash = [](const std::string& more) {
    const Manifest manifest = dose_study(adaptive_members("yes_no", more));
    return design_hash(manifest, plan_sessions(manifest));
  };
  std::set<std::string> hashes;
  for (const char* more :
       {"factor: dose", "factor: dose, trials: 41", "factor: dose, tracks: 2",
        "factor: dose, noise: 0.3", "factor: dose, method: staircase",
        "factor: dose, method: staircase, down: 3", "factor: dots, easier: falling"})
    hashes.insert(hash(more));
  EXPECT_EQ(hashes.size(), 7u);
}

TEST(AdaptiveSimulation, FollowsTheProcedureAndTheStatedObservers) {
  const Manifest manifest = dose_study(
      adaptive_members("yes_no", "factor: dose, method: staircase, trials: 200, noise: 0.5"));
  const SimulatedParticipants people = {
      .observers = {.threshold = 1.5, .threshold_deviation = 0.0, .width = 0.2, .guess = 0.15}};
  const std::vector<SessionPlan> plans = plan_sessions(manifest, {}, 4);
  const std::vector<AnswerRow> rows = simulated_sessions(manifest, plans, {}, people);
  EXPECT_EQ(rows.size(), 4u * 400u);
  int alarms = 0, noise = 0;
  for (const AnswerRow& row : rows) {
    EXPECT_TRUE(row.simulated);
    EXPECT_EQ(level_of(manifest.stimuli[0], "dose"), "0");
    if (row.track) continue;
    EXPECT_EQ(row.level, "0");
    ++noise;
    alarms += row.value == "yes" ? 1 : 0;
  }
  // Of 800: 0.15 ± 4 standard errors.
  EXPECT_EQ(noise, 800);
  EXPECT_NEAR(1.0 * alarms / noise, 0.15, 4.0 * std::sqrt(0.15 * 0.85 / 800));
  // 1 up 2 down comes to 70.7 %, which is the threshold by default: levels lie around 1.5.
  double sum = 0.0;
  int counted = 0;
  for (const AnswerRow& row : rows)
    if (row.track && row.trial > 60) sum += std::stod(row.level), ++counted;
  EXPECT_NEAR(sum / counted, 1.5, 0.2);
  EXPECT_EQ(to_csv(rows), to_csv(simulated_sessions(manifest, plans, {}, people)));
}

TEST(AdaptiveSimulation, EndsWithTheReversals) {
  const Manifest manifest = dose_study(adaptive_members(
      "two_interval", "factor: dose, method: staircase, reversals: 4, trials: 100, tracks: 2"));
  const std::vector<AnswerRow> rows = simulated_sessions(manifest, plan_sessions(manifest), {}, {});
  EXPECT_LT(rows.size(), 3u * 150u);
  EXPECT_GT(rows.size(), 3u * 2u * 5u);
}

}  // namespace
}  // namespace mien::pipeline
