#include "pipeline/study/results/pair_worth.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/study/results/pair_preferences.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

const StatedTruth truth_of_pairs = {{{"acted-sad", "sad-happy"}, -0.4},
                                    {{"sad", "sad-happy"}, -0.2},
                                    {{"walk", "sad-happy"}, 0.0},
                                    {{"happy", "sad-happy"}, 0.2},
                                    {{"acted-happy", "sad-happy"}, 0.4}};

PairWorth worth_of_answers(const Manifest& manifest, const std::vector<AnswerRow>& rows) {
  const std::vector<PairWorth> worths = worths_of(collect_answers(manifest, rows));
  EXPECT_EQ(worths.size(), 1u);
  return worths.at(0);
}

/// Changes an answer to "left", "right" or "tie".
void set_answer(AnswerRow& row, const std::string& answer) {
  row.value_raw = answer;
  row.value = answer == "left" ? row.stimulus : answer == "right" ? row.against : answer;
}

TEST(PairWorth, OrdersStimuliAsTheyWereMeant) {
  const Manifest manifest = all_pairs_study(24);
  const PairWorth worth = worth_of_answers(manifest, answers_to(manifest, truth_of_pairs));
  EXPECT_EQ(worth.item, "sad-happy");
  EXPECT_EQ(worth.people, 24);
  EXPECT_EQ(worth.comparisons, 240);
  EXPECT_TRUE(worth.has_order);
  EXPECT_TRUE(worth.is_by_participants);
  ASSERT_EQ(worth.stimuli.size(), 5u);
  // In the order of the manifest: walk, acted-sad, acted-happy, sad, happy.
  std::vector<double> found;
  for (const std::size_t i : {1, 3, 0, 4, 2}) found.push_back(worth.stimuli[i].worth);
  EXPECT_TRUE(std::ranges::is_sorted(found));
  double sum = 0.0;
  for (const StimulusWorth& one : worth.stimuli) {
    sum += one.worth;
    EXPECT_EQ(one.comparisons(), 96);
    EXPECT_LT(one.by_participants.low, one.worth);
    EXPECT_GT(one.by_participants.high, one.worth);
    EXPECT_EQ(one.by_participants.low, worth.ends_of(one).low);
  }
  EXPECT_NEAR(sum, 0.0, 1e-9);
  EXPECT_LT(worth.equal.p, 1e-6);
  EXPECT_EQ(worth.equal.degrees, 4);
  EXPECT_EQ(worth.triads.size(), 24u);
  EXPECT_EQ(worth.transitivity.triads, 10);
}

TEST(PairWorth, TreatsAllAnswersAsIndependentWithFewParticipants) {
  const Manifest manifest = all_pairs_study(9);
  const PairWorth worth = worth_of_answers(manifest, answers_to(manifest, truth_of_pairs));
  EXPECT_FALSE(worth.is_by_participants);
  EXPECT_EQ(worth.ends_of(worth.stimuli[0]).low, worth.stimuli[0].by_answers.low);
}

TEST(PairWorth, FindsWhoAlwaysChoosesTheLeft) {
  const Manifest manifest = all_pairs_study(24);
  std::vector<AnswerRow> rows = answers_to(manifest);
  int next = 0;
  for (AnswerRow& row : rows)
    if (row.counts()) set_answer(row, next++ % 4 == 0 ? "right" : "left");
  const PairWorth worth = worth_of_answers(manifest, rows);
  EXPECT_NEAR(worth.fit.order, std::log(3.0), 0.25);
  EXPECT_LT(worth.order.p, 1e-6);
  EXPECT_GT(worth.order_ends.low, 0.5);
  for (AnswerRow& row : rows)
    if (row.counts()) set_answer(row, "left");
  const PairWorth left = worth_of_answers(manifest, rows);
  EXPECT_FALSE(left.has_order);
  EXPECT_TRUE(std::isnan(left.order.p));
}

TEST(PairWorth, CountsTiesForNeither) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest, truth_of_pairs);
  const auto choices_before = preferences_of(collect_answers(manifest, rows));
  int tied = 0;
  for (AnswerRow& row : rows) {
    const bool is_pair = (row.stimulus == "walk" && row.against == "sad") ||
                         (row.stimulus == "sad" && row.against == "walk");
    if (!row.counts() || !is_pair) continue;
    set_answer(row, "tie");
    ++tied;
  }
  EXPECT_EQ(tied, 12);
  const PairWorth worth = worth_of_answers(manifest, rows);
  EXPECT_EQ(worth.ties, 12);
  EXPECT_EQ(worth.comparisons, 120);
  EXPECT_EQ(worth.stimuli[0].ties, 12);  // walk
  EXPECT_EQ(worth.stimuli[3].ties, 12);  // sad
  EXPECT_EQ(worth.stimuli[1].ties, 0);
  EXPECT_TRUE(std::isfinite(worth.fit.tie));
  EXPECT_TRUE(worth.triads.empty());
  // They are no choices: without others, the pair is not in the table of choices.
  EXPECT_EQ(preferences_of(collect_answers(manifest, rows)).size(), choices_before.size() - 1);
}

TEST(PairWorth, CountsTiesBesideChoices) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest, truth_of_pairs);
  const auto tied = std::ranges::find_if(rows, [](const AnswerRow& row) {
    return row.counts() && (row.stimulus == "walk" || row.against == "walk") &&
           (row.stimulus == "sad" || row.against == "sad");
  });
  set_answer(*tied, "tie");
  int pairs = 0;
  for (const PreferenceCount& count : preferences_of(collect_answers(manifest, rows))) {
    const bool is_pair = count.one == 0 && count.other == 3;  // walk and sad
    EXPECT_EQ(count.ties, is_pair ? 1 : 0);
    EXPECT_EQ(count.trials, is_pair ? 11 : 12);
    pairs += is_pair ? 1 : 0;
  }
  EXPECT_EQ(pairs, 1);
}

TEST(PairWorth, RefusesATieThatWasNotGiven) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest);
  rows[0].value = "tie";  // the raw answer is a side
  EXPECT_THROW(collect_answers(manifest, rows), Faults);
}

TEST(PairWorth, HasNoNumberForWhatIsAlwaysChosen) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows) {
    if (!row.counts()) continue;
    if (row.stimulus == "happy") set_answer(row, "left");
    if (row.against == "happy") set_answer(row, "right");
  }
  const PairWorth worth = worth_of_answers(manifest, rows);
  const StimulusWorth& happy = worth.stimuli[4];
  EXPECT_EQ(happy.record, WinRecord::always_won);
  EXPECT_EQ(record_text(happy), "always chosen");
  EXPECT_TRUE(std::isnan(happy.worth));
  EXPECT_TRUE(std::isnan(worth.ends_of(happy).high));
  EXPECT_TRUE(std::isfinite(worth.stimuli[0].worth));
  EXPECT_TRUE(worth.is_by_participants);
  EXPECT_LT(worth.equal.p, 0.01);
}

TEST(PairWorth, OfNothingButTiesIsNotDetermined) {
  const Manifest manifest = all_pairs_study(12);
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows)
    if (row.counts()) set_answer(row, "tie");
  const PairWorth worth = worth_of_answers(manifest, rows);
  EXPECT_EQ(worth.ties, 120);
  EXPECT_TRUE(std::isnan(worth.stimuli[0].worth));
  EXPECT_EQ(record_text(worth.stimuli[0]), "not determined by the answers");
  EXPECT_FALSE(worth.is_by_participants);
  EXPECT_TRUE(std::isnan(worth.equal_adjusted));
}

TEST(PairWorth, IsTheSameEachTime) {
  const Manifest manifest = all_pairs_study(12);
  const std::vector<AnswerRow> rows = answers_to(manifest, truth_of_pairs);
  const PairWorth one = worth_of_answers(manifest, rows);
  const PairWorth again = worth_of_answers(manifest, rows);
  for (std::size_t i = 0; i < one.stimuli.size(); ++i) {
    EXPECT_EQ(one.stimuli[i].by_participants.low, again.stimuli[i].by_participants.low);
    EXPECT_EQ(one.stimuli[i].elo.mean, again.stimuli[i].elo.mean);
  }
}

TEST(PairWorth, IsCorrectedOverAllItems) {
  Manifest manifest = all_pairs_study(12);
  manifest.questionnaire->scales.ids = {"sad-happy", "weak-strong"};
  const auto worths = worths_of(collect_answers(manifest, answers_to(manifest)));
  ASSERT_EQ(worths.size(), 2u);
  const double least = std::min(worths[0].equal.p, worths[1].equal.p);
  const double adjusted = std::min(worths[0].equal_adjusted, worths[1].equal_adjusted);
  EXPECT_NEAR(adjusted, std::min(1.0, 2.0 * least), 1e-12);
}

}  // namespace
}  // namespace mien::pipeline
