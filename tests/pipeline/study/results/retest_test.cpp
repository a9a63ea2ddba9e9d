#include "pipeline/study/results/retest.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/study/results/results.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

Manifest repeating_study(int participants = 6) {
  Manifest manifest = two_emotion_study(participants);
  manifest.questionnaire->repeated = 1;
  manifest.questionnaire->attention_every = 2;
  return manifest;
}

std::vector<RetestAnswer> repeated_answers(const Manifest& manifest,
                                           const std::vector<AnswerRow>& rows) {
  return retest_answers_of(collect_answers(manifest, rows), rows);
}

void answer(AnswerRow& row, double value) {
  row.value = std::to_string(value);
  row.value_raw = std::to_string(100.0 * (row.pole_left == "low" ? value + 2.0 : 2.0 - value) / 4);
}

bool is_second(const AnswerRow& row) { return row.is_check && row.kind != "attention"; }

TEST(RetestAnswers, AreThoseShownASecondTimeAndNoChecks) {
  const Manifest manifest = repeating_study();
  const std::vector<AnswerRow> rows = answers_to(manifest);
  ASSERT_GT(std::ranges::count(rows, "attention", &AnswerRow::kind), 0);
  const std::vector<RetestAnswer> answers = repeated_answers(manifest, rows);
  ASSERT_EQ(answers.size(), 6u * 1u * 2u);
  for (const RetestAnswer& one : answers) EXPECT_LT(one.first_trial, one.second_trial);
}

TEST(RetestAnswers, PairTheAnswerThatCountsWithTheSecondOne) {
  const Manifest manifest = repeating_study();
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows) {
    if (row.kind == "attention") continue;
    answer(row, is_second(row) ? -1.0 : 0.5);
  }
  for (const RetestAnswer& one : repeated_answers(manifest, rows)) {
    ASSERT_TRUE(one.difference);
    EXPECT_DOUBLE_EQ(*one.difference, -1.5);
    EXPECT_FALSE(one.is_equal());
    const auto first = std::ranges::find_if(rows, [&](const AnswerRow& row) {
      return row.participant == one.participant && row.trial == one.first_trial;
    });
    EXPECT_EQ(first->stimulus, one.stimulus);
    EXPECT_TRUE(first->counts());
  }
}

// Of four people the first ratings 0, 1, 0, 1 and the second 0, 1, 1, 0.5 on either scale.
TEST(RetestAnswers, AreSummedUpOverAllByScaleAndByPerson) {
  const Manifest manifest = repeating_study(4);
  std::vector<AnswerRow> rows = answers_to(manifest);
  constexpr std::array first = {0.0, 1.0, 0.0, 1.0};
  constexpr std::array second = {0.0, 1.0, 1.0, 0.5};
  for (AnswerRow& row : rows) {
    const auto person = static_cast<std::size_t>(row.participant.back() - '1');
    if (row.kind != "attention") answer(row, is_second(row) ? second[person] : first[person]);
  }
  const std::vector<RetestSummary> all = retest_summaries_of(repeated_answers(manifest, rows));
  ASSERT_EQ(all.size(), 1u + 2u + 4u);
  EXPECT_EQ(all[0].answers, 8);
  EXPECT_EQ(all[0].equal, 4);
  EXPECT_DOUBLE_EQ(all[0].mean_difference, 1.5 / 4.0);
  EXPECT_NEAR(all[0].retest.r, 0.25 / std::sqrt(0.6875), 1e-9);
  EXPECT_EQ(all[1].item, "sad-happy");
  EXPECT_EQ(all[1].answers, 4);
  EXPECT_EQ(all[3].participant, "p001");
  EXPECT_EQ(all[3].equal, 2);
  EXPECT_TRUE(std::isnan(all[3].retest.r));
  EXPECT_DOUBLE_EQ(all[5].mean_difference, 1.0);
}

TEST(RetestAnswers, OfWhoIsLeftOutAreToldButNotCounted) {
  const Manifest manifest = repeating_study();
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows)
    if (row.participant == "p003" && row.kind == "attention") row.passed = false;
  const AnswerSet answer_set = collect_answers(manifest, rows, {.max_failed_checks = 0});
  const std::vector<RetestSummary> all = retest_summaries_of(retest_answers_of(answer_set, rows));
  EXPECT_EQ(all[0].answers, 5 * 2);
  const auto own = std::ranges::find(all, "p003", &RetestSummary::participant);
  ASSERT_NE(own, all.end());
  EXPECT_TRUE(own->is_excluded);
  EXPECT_EQ(own->answers, 2);
}

TEST(RetestAnswers, OfChoicesAndPairsAreTheSameOrNot) {
  Manifest manifest = repeating_study();
  manifest.questionnaire->attention_every = 0;
  manifest.questionnaire->trials = &emotion_form;
  std::vector<AnswerRow> rows = answers_to(manifest);
  std::erase_if(rows, [](const AnswerRow& row) { return row.item != "emotion"; });
  for (AnswerRow& row : rows) row.value = is_second(row) ? "happy" : "sad";
  std::vector<RetestAnswer> answers = repeated_answers(manifest, rows);
  ASSERT_EQ(answers.size(), 6u);
  EXPECT_FALSE(answers[0].difference);
  EXPECT_FALSE(answers[0].is_equal());
  EXPECT_TRUE(std::isnan(retest_summaries_of(answers)[0].mean_difference));

  manifest.questionnaire->trials = &pair_form;
  manifest.questionnaire->pairs = {{"walk", "sad"}, {"walk", "happy"}, {"sad", "happy"}};
  manifest.questionnaire->scales.ids = {"sad-happy"};
  rows = answers_to(manifest);
  for (AnswerRow& row : rows) {
    row.value = std::min(row.stimulus, row.against);  // whichever stands at the left
    if (is_second(row)) std::swap(row.stimulus, row.against);
  }
  answers = repeated_answers(manifest, rows);
  ASSERT_EQ(answers.size(), 6u);
  for (const RetestAnswer& one : answers) EXPECT_TRUE(one.is_equal());
}

TEST(RetestAnswers, AreNoneWithoutRepetitions) {
  const Manifest manifest = two_emotion_study(2);
  const std::vector<AnswerRow> rows = answers_to(manifest);
  EXPECT_TRUE(repeated_answers(manifest, rows).empty());
  EXPECT_TRUE(retest_summaries_of({}).empty());
}

}  // namespace
}  // namespace mien::pipeline
