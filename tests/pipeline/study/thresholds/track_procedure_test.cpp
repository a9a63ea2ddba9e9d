#include "pipeline/study/thresholds/track_procedure.h"

#include <random>

#include <gtest/gtest.h>

#include "pipeline/study/thresholds/dose_study.h"
#include "pipeline/study/thresholds/simulated_observer.h"
#include "pipeline/study/thresholds/threshold_posterior.h"
#include "pipeline/study/thresholds/track_json.h"

namespace mien::pipeline {
namespace {

using mien::test::adaptive_members;
using mien::test::dose_study;

TrackProcedure procedure_for(const std::string& form, const std::string& more) {
  return track_procedure(dose_study(adaptive_members(form, more)));
}

TEST(TrackProcedure, IsReadAsItWasWritten) {
  for (const char* more :
       {"factor: dose", "factor: dots, easier: falling",
        "factor: dose, until: {sd: 0.4, at_most: 30}, proportion: 0.8",
        "factor: dose, method: staircase, up: 2, down: 3, step: {up: 2, down: 1}, reversals: 6, "
        "trials: 30, start: middle"}) {
    const TrackProcedure written = procedure_for("same_different", more);
    const TrackProcedure read =
        procedure_of(nlohmann::ordered_json::parse(procedure_json(written).dump()));
    EXPECT_EQ(read.method, written.method) << more;
    EXPECT_EQ(read.levels, written.levels) << more;
    EXPECT_EQ(read.ease, written.ease) << more;
    EXPECT_EQ(read.quest, written.quest) << more;
    EXPECT_EQ(read.end, written.end) << more;
    EXPECT_EQ(procedure_json(read), procedure_json(written)) << more;
    const TrackLevels one(read), other(written);
    std::mt19937 random(7);
    std::vector<TrackAnswer> answers;
    for (int i = 0; i < 20; ++i) {
      const auto next = one.next(answers);
      ASSERT_EQ(next, other.next(answers)) << more;
      if (!next) break;
      answers.push_back({*next, random() % 3 > 0});
    }
  }
}

TEST(TrackProcedure, CountsEaseDownwardsWhereLowerLevelsAreEasier) {
  const TrackProcedure falling = procedure_for("yes_no", "factor: dots, easier: falling");
  EXPECT_EQ(falling.ease, (std::vector<double>{-60, -50, -40, -30, -20, -10}));
  EXPECT_EQ(falling.levels.front(), "60");
}

TEST(TrackLevels, OfAStaircaseAreThoseOfLevittsExample) {
  // 1 up, 2 down from the easiest of six levels.
  const TrackLevels levels(procedure_for("yes_no", "factor: dose, method: staircase, trials: 10"));
  std::vector<TrackAnswer> answers;
  std::vector<std::size_t> places;
  for (const bool is_positive : {true, true, true, true, true, false, true, true, false, true}) {
    const auto next = levels.next(answers);
    ASSERT_TRUE(next);
    places.push_back(*next);
    EXPECT_TRUE(levels.permits(answers, *next));
    EXPECT_FALSE(levels.permits(answers, *next + 1));
    answers.push_back({*next, is_positive});
  }
  EXPECT_EQ(places, (std::vector<std::size_t>{5, 5, 4, 4, 3, 3, 4, 4, 3, 4}));
  EXPECT_FALSE(levels.next(answers)) << "after 10 trials";
}

TEST(TrackLevels, OfAStaircaseEndWithTheReversals) {
  const TrackLevels levels(
      procedure_for("yes_no", "factor: dose, method: staircase, down: 1, reversals: 3"));
  std::vector<TrackAnswer> answers;
  for (const bool is_positive : {true, false, true, false}) {
    const auto next = levels.next(answers);
    ASSERT_TRUE(next) << answers.size();
    answers.push_back({*next, is_positive});
  }
  EXPECT_FALSE(levels.next(answers)) << "three changes of direction";
  EXPECT_FALSE(levels.permits(answers, 5));
}

TEST(TrackLevels, OfQuestFollowTheObserver) {
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, trials: 60"));
  const TrackProcedure procedure = track_procedure(manifest);
  const TrackLevels levels(procedure);
  // Simulated observers with thresholds of 1 and 2.5: levels gather around them.
  for (const double threshold : {1.0, 2.5}) {
    const PsychometricFunction observer = simulated_observer(
        manifest, procedure,
        {.threshold = threshold, .threshold_deviation = 0.0, .width = 0.2, .lapse = 0.01}, 1);
    EXPECT_NEAR(answer_probability(observer, threshold).positive, 0.75, 1e-12);
    std::mt19937 random(11);
    std::vector<TrackAnswer> answers;
    double sum = 0.0;
    constexpr int trials = 60, settled = 20;
    for (int i = 0; i < trials; ++i) {
      const std::size_t place = levels.next(answers).value();
      EXPECT_TRUE(levels.permits(answers, place));
      const double level = procedure.ease[place];
      if (i >= settled) sum += level;
      const double drawn = std::uniform_real_distribution<>(0.0, 1.0)(random);
      answers.push_back({place, drawn < answer_probability(observer, level).positive});
    }
    EXPECT_NEAR(sum / (trials - settled), threshold, 0.5);
    const ThresholdPosterior found = threshold_posterior(
        levels.quest(), posterior_after(levels.quest(), quest_answers(answers)), 0.75);
    EXPECT_NEAR(found.mean, threshold, 0.3);
    EXPECT_LT(found.low, threshold);
    EXPECT_GT(found.high, threshold);
    EXPECT_LT(found.deviation, 0.2);
  }
}

TEST(TrackLevels, OfQuestPermitNothingThatIsWorse) {
  const TrackLevels levels(procedure_for("yes_no", "factor: dose"));
  const std::vector<TrackAnswer> answers = {{3, true}, {2, true}, {1, false}};
  int permitted = 0;
  for (std::size_t place = 0; place < 6; ++place) permitted += levels.permits(answers, place);
  EXPECT_EQ(permitted, 1);
  EXPECT_FALSE(levels.permits(answers, 6));
}

/// The answers of a simulated observer until the track ends, at most 300.
std::vector<TrackAnswer> answered_track(const Manifest& manifest, double threshold, unsigned seed) {
  const TrackProcedure procedure = track_procedure(manifest);
  const TrackLevels levels(procedure);
  const PsychometricFunction observer = simulated_observer(
      manifest, procedure, {.threshold = threshold, .threshold_deviation = 0.0, .lapse = 0.01}, 1);
  std::mt19937 random(seed);
  std::vector<TrackAnswer> answers;
  while (answers.size() < 300) {
    const auto place = levels.next(answers);
    if (!place) break;
    const double drawn = std::uniform_real_distribution<>(0.0, 1.0)(random);
    const double positive = answer_probability(observer, procedure.ease[*place]).positive;
    answers.push_back({*place, drawn < positive});
  }
  return answers;
}

TEST(TrackLevels, OfQuestEndOnceTheThresholdIsKnownWellEnough) {
  constexpr double sd = 0.3;
  const Manifest manifest =
      dose_study(adaptive_members("two_interval", "factor: dose, until: {sd: 0.3, at_most: 200}"));
  const TrackLevels levels(track_procedure(manifest));
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const std::vector<TrackAnswer> answers = answered_track(manifest, 1.5, seed);
    ASSERT_LT(answers.size(), 200U);
    ASSERT_GT(answers.size(), 5U);
    Eigen::VectorXd posterior = levels.quest().prior;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      posterior = updated(levels.quest(), posterior, quest_answers(answers)[i]);
      const double deviation = threshold_posterior(levels.quest(), posterior, 0.75).deviation;
      EXPECT_EQ(deviation <= sd, i + 1 == answers.size()) << seed << ": trial " << i + 1;
    }
    EXPECT_TRUE(levels.permits_end(answers, true));
    EXPECT_FALSE(levels.permits_end(answers, false));
    const std::vector<TrackAnswer> earlier(answers.begin(), answers.end() - 1);
    EXPECT_FALSE(levels.permits_end(earlier, true));
    EXPECT_TRUE(levels.permits_end(earlier, false));
  }
}

TEST(TrackLevels, OfQuestTakeLongerToKnowMoreAndNoLongerThanTheyMay) {
  const auto trials_until = [](const char* until) {
    const Manifest manifest =
        dose_study(adaptive_members("two_interval", std::string("factor: dose, until: ") + until));
    return answered_track(manifest, 1.5, 5).size();
  };
  const std::size_t coarse = trials_until("{sd: 0.5, at_most: 250}");
  const std::size_t fine = trials_until("{sd: 0.2, at_most: 250}");
  EXPECT_GT(coarse, 3U);
  EXPECT_GT(fine, coarse + 10);
  EXPECT_LT(fine, 250U);
  EXPECT_EQ(trials_until("{sd: 0.2, at_most: 20}"), 20U);
}

TEST(TrackLevels, WithoutAnEndGoOnAsLongAsThePlan) {
  const Manifest manifest = dose_study(adaptive_members("two_interval", "factor: dose"));
  const std::vector<TrackAnswer> answers = answered_track(manifest, 1.5, 1);
  EXPECT_EQ(answers.size(), 300U);
  EXPECT_FALSE(TrackLevels(track_procedure(manifest)).permits_end(answers, true));
}

TEST(ThresholdPosteriors, AreThoseOfTheParametersWhereTheThresholdIsTheLocation) {
  // Without guesses and lapses, one half is reached at the location.
  const QuestPlus quest = psychometric_quest(Sigmoid::logistic, {1, 2, 3}, {{1, 2, 3, 4}},
                                             {{0.5, 1.0}}, {{0.0}}, {{0.0}});
  const Eigen::VectorXd posterior = posterior_after(quest, {{0, 0}, {1, 1}, {2, 1}});
  const ThresholdPosterior found = threshold_posterior(quest, posterior, 0.5);
  const QuestEstimate location = quest_estimate(quest, posterior, 0);
  EXPECT_NEAR(found.mean, location.mean, 1e-12);
  EXPECT_NEAR(found.deviation, location.deviation, 1e-12);
  EXPECT_EQ(found.low, location.low);
  EXPECT_EQ(found.high, location.high);
  EXPECT_NEAR(found.without, 0.0, 1e-12);
}

TEST(ThresholdPosteriors, LeaveOutFunctionsThatNeverReachTheProportion) {
  const QuestPlus quest =
      psychometric_quest(Sigmoid::logistic, {0, 1}, {{0.0}}, {{1.0}}, {{0.0, 0.4}}, {{0.0}});
  const ThresholdPosterior found = threshold_posterior(quest, quest.prior, 0.3);
  EXPECT_NEAR(found.without, 0.5, 1e-12);
  EXPECT_NEAR(found.mean, std::log(0.3 / 0.7), 1e-12);
  EXPECT_TRUE(std::isnan(threshold_posterior(quest, quest.prior, 1.0).mean));
}

TEST(SimulatedObservers, HaveTheStatedThresholdAlsoWhereLowerLevelsAreEasier) {
  const Manifest manifest = dose_study(
      adaptive_members("same_different", "factor: dots, easier: falling, proportion: 0.6"));
  const TrackProcedure procedure = track_procedure(manifest);
  const SimulatedObservers stated = {
      .threshold = 35.0, .threshold_deviation = 0.0, .width = 4.0, .guess = 0.2, .lapse = 0.05};
  const PsychometricFunction observer = simulated_observer(manifest, procedure, stated, 3);
  EXPECT_NEAR(answer_probability(observer, -35.0).positive, 0.6, 1e-12);
  EXPECT_GT(answer_probability(observer, -10.0).positive, 0.9);
  EXPECT_NEAR(answer_probability(observer, -1000.0).positive, 0.2, 1e-6);
  EXPECT_THROW(simulated_observer(manifest, procedure, {.guess = 0.7}, 3), Error);
}

}  // namespace
}  // namespace mien::pipeline
