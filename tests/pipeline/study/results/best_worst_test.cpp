// Best–worst scaling by simulated participants whose opinions are known.

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/results/best_worst_scores.h"
#include "pipeline/study/results/pair_worth.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

Manifest set_study(int participants, int size = 3, int sets = 10) {
  Manifest manifest = two_emotion_study(participants);
  Questionnaire& asked = *manifest.questionnaire;
  asked.trials = &best_worst_form;
  asked.scales.ids = {"sad-happy"};
  asked.answer.slider = false;
  asked.best_worst = {.size = size, .sets = sets};
  return manifest;
}

// Stimuli in the order of the manifest: walk, acted-sad, acted-happy, sad, happy.
const StatedTruth truth_of_sets = {{{"acted-sad", "sad-happy"}, -0.4},
                                   {{"sad", "sad-happy"}, -0.2},
                                   {{"walk", "sad-happy"}, 0.0},
                                   {{"happy", "sad-happy"}, 0.2},
                                   {{"acted-happy", "sad-happy"}, 0.4}};

TEST(BestWorst, ImpliesThatTheBestBeatsAllAndAllBeatTheWorst) {
  const AnalysedSet set{.person = 2, .stimuli = {7, 5, 8, 6}, .scale = "s", .best = 1, .worst = 2};
  std::set<std::pair<std::size_t, std::size_t>> beaten;
  for (const AnalysedPreference& one : implied_preferences(set)) {
    EXPECT_TRUE(beaten.emplace(one.chosen, one.other).second);
    EXPECT_EQ(one.person, 2u);
    EXPECT_EQ(one.item, "s");
    EXPECT_FALSE(one.is_tie);
    const auto place = [&](std::size_t stimulus) {
      return std::ranges::find(set.stimuli, stimulus) - set.stimuli.begin();
    };
    EXPECT_EQ(one.is_left_chosen, place(one.chosen) < place(one.other));
  }
  EXPECT_EQ(beaten, (std::set<std::pair<std::size_t, std::size_t>>{
                        {5, 7}, {5, 8}, {5, 6}, {7, 8}, {6, 8}}));
}

TEST(BestWorst, ScoresAndWorthsAreInTheOrderOfTheTruth) {
  const Manifest manifest = set_study(40);
  const AnswerSet answers = collect_answers(manifest, answers_to(manifest, truth_of_sets));
  EXPECT_EQ(answers.sets.size(), 400u);
  EXPECT_EQ(answers.preferences.size(), 1200u);
  const auto scores = best_worst_scores(answers);
  ASSERT_EQ(scores.size(), 5u);
  const auto worths = worths_of(answers);
  ASSERT_EQ(worths.size(), 1u);
  EXPECT_EQ(worths[0].item, "sad-happy");
  EXPECT_TRUE(worths[0].is_by_participants);
  std::vector<double> score, worth;
  for (const std::size_t i : {1, 3, 0, 4, 2}) {
    score.push_back(scores[i].score());
    worth.push_back(worths[0].stimuli[i].worth);
    EXPECT_EQ(scores[i].shown, 240);
    EXPECT_EQ(scores[i].people, 40);
    EXPECT_LT(scores[i].ends.low, scores[i].score());
    EXPECT_GT(scores[i].ends.high, scores[i].score());
  }
  EXPECT_TRUE(std::ranges::is_sorted(score));
  EXPECT_TRUE(std::ranges::is_sorted(worth));
  // Implied preferences are not independent: no tests, no transitivity.
  EXPECT_TRUE(std::isnan(worths[0].equal.p));
  EXPECT_TRUE(std::isnan(worths[0].order.p));
  EXPECT_EQ(worths[0].transitivity.triads, 0);
  EXPECT_TRUE(worths[0].triads.empty());
}

/// Answers about all sets of four of five stimuli, by participants whose utilities are worths with
/// Gumbel's distribution, under which comparisons of two follow Bradley and Terry's model.
AnswerSet answers_by_utility(const std::vector<double>& worths, int people, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto gumbel = [&] {
    return -std::log(-std::log((static_cast<double>(random() >> 11) + 0.5) * 0x1p-53));
  };
  AnswerSet answers;
  answers.form = &best_worst_form;
  for (std::size_t i = 0; i < worths.size(); ++i) answers.stimuli.push_back({.id = {}});
  for (int person = 0; person < people; ++person) {
    answers.people.push_back(std::to_string(person));
    for (std::size_t omitted = 0; omitted < worths.size(); ++omitted) {
      AnalysedSet set{.person = static_cast<std::size_t>(person), .stimuli = {}, .scale = "s"};
      std::vector<double> utilities;
      for (std::size_t i = 0; i < worths.size(); ++i)
        if (i != omitted) set.stimuli.push_back(i);
      std::ranges::shuffle(set.stimuli, random);
      for (const std::size_t one : set.stimuli) utilities.push_back(worths[one] + gumbel());
      set.best = static_cast<std::size_t>(std::ranges::max_element(utilities) - utilities.begin());
      set.worst = static_cast<std::size_t>(std::ranges::min_element(utilities) - utilities.begin());
      for (const AnalysedPreference& one : implied_preferences(set))
        answers.preferences.push_back(one);
      answers.sets.push_back(std::move(set));
    }
  }
  return answers;
}

TEST(BestWorst, HasNoIntervalsOfFewPeople) {
  for (const int people : {fewest_resampled_people - 1, fewest_resampled_people}) {
    const auto worths = worths_of(answers_by_utility({0.5, -0.5, 0.0, 0.2, -0.2}, people, 3));
    ASSERT_EQ(worths.size(), 1u);
    for (const StimulusWorth& one : worths[0].stimuli)
      EXPECT_EQ(std::isfinite(worths[0].ends_of(one).low), people == fewest_resampled_people);
  }
}

TEST(BestWorst, FindsKnownWorthsApproximately) {
  const std::vector<double> truth = {-1.0, -0.5, 0.0, 0.4, 1.1};
  const auto worths = worths_of(answers_by_utility(truth, 2000, 5));
  ASSERT_EQ(worths.size(), 1u);
  double greatest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    greatest = std::max(greatest, std::abs(worths[0].stimuli[i].worth - truth[i]));
    RecordProperty("worth " + std::to_string(truth[i]), std::to_string(worths[0].stimuli[i].worth));
  }
  EXPECT_LT(greatest, 0.15);
  EXPECT_NEAR(worths[0].fit.order, 0.0, 0.06);
}

TEST(BestWorst, LeavesOutSetsOfWhichHalfIsMissing) {
  const Manifest manifest = set_study(4);
  auto rows = answers_to(manifest);
  const auto complete = collect_answers(manifest, rows).sets.size();
  rows.erase(rows.begin());  // the best of the first set
  EXPECT_EQ(collect_answers(manifest, rows).sets.size(), complete - 1);
  rows.erase(rows.begin() + 2);  // the worst of the second
  EXPECT_EQ(collect_answers(manifest, rows).sets.size(), complete - 2);
}

TEST(BestWorst, RefusesWhatNoPageOffers) {
  const Manifest manifest = set_study(4);
  const auto rows = answers_to(manifest);
  auto foreign = rows;
  foreign[0].value = "nobody";
  EXPECT_THROW(collect_answers(manifest, foreign), Faults);
  auto both = rows;  // the best is the worst, too
  both[1].value = both[0].value;
  EXPECT_THROW(collect_answers(manifest, both), Faults);
  auto unknown = rows;
  unknown[0].item = "sad-happy/better";
  EXPECT_THROW(collect_answers(manifest, unknown), Faults);
  auto other_set = rows;
  other_set[0].against = "walk nobody";
  EXPECT_THROW(collect_answers(manifest, other_set), Faults);
}

}  // namespace
}  // namespace mien::pipeline
