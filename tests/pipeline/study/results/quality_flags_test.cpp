#include "pipeline/study/results/quality_flags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/answers/trial_form.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

/// A rating of p001, one trial each.
AnswerRow rated(int trial, const std::string& raw) {
  AnswerRow row;
  row.participant = "p001";
  row.trial = trial;
  row.stimulus = "walk";
  row.item = "sad-happy";
  row.value_raw = raw;
  row.value = "0";
  return row;
}

std::vector<AnswerRow> rated_as(const std::vector<std::string>& raw) {
  std::vector<AnswerRow> rows;
  for (const std::string& one : raw) rows.push_back(rated(static_cast<int>(rows.size()) + 1, one));
  return rows;
}

QualityFlags flags_by(const QualityRules& rules, const std::vector<AnswerRow>& rows) {
  Questionnaire questionnaire;
  questionnaire.analysis.quality = rules;
  return quality_flags(questionnaire, rows);
}

/// The reasons for which p001 is flagged.
std::string reasons_by(const QualityRules& rules, const std::vector<AnswerRow>& rows) {
  return reasons_text(flags_by(rules, rows).of_participant("p001"));
}

QualityRules longstring(int most) { return {.max_longstring = most}; }
QualityRules deviation(double least) { return {.min_sd = least}; }

TEST(QualityFlags, OfResponseTimesAreBeyondTheBoundsNotAtThem) {
  std::vector<AnswerRow> rows = rated_as({"1", "2", "3", "4", "5"});
  const std::array<std::optional<double>, 5> times = {249.5, 250.0, 60000.0, 60000.5, std::nullopt};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].rt_ms = times[i];
  const QualityFlags flags = flags_by({.min_rt_ms = 250.0, .max_rt_ms = 60000.0}, rows);
  ASSERT_EQ(flags.answers.size(), 2u);
  EXPECT_EQ(reasons_text(flags.of_answer(0)), "response time 249.5 ms < 250 ms");
  EXPECT_EQ(reasons_text(flags.of_answer(3)), "response time 60000.5 ms > 60000 ms");
  EXPECT_EQ(flags.of_answer(3).front().rule, QualityRule::max_rt_ms);
  EXPECT_TRUE(flags.participants.empty());
}

TEST(QualityFlags, OfALeftWindowConcernAllAnswersOfTheTrial) {
  std::vector<AnswerRow> rows = {rated(1, "1"), rated(1, "2"), rated(2, "3"), rated(3, "4")};
  rows[1].item = "weak-strong";
  rows[0].blur_ms = rows[1].blur_ms = 5001.0;
  rows[2].blur_ms = 5000.0;
  const QualityFlags flags = flags_by({.max_blur_ms = 5000.0}, rows);
  EXPECT_EQ(flags.answers.size(), 2u);
  EXPECT_EQ(reasons_text(flags.of_answer(0)), "window left for 5001 ms > 5000 ms");
  EXPECT_EQ(reasons_text(flags.of_answer(1)), reasons_text(flags.of_answer(0)));
}

TEST(QualityFlags, CountTheLongestRun) {
  EXPECT_EQ(longest_run({}), 0);
  EXPECT_EQ(longest_run(std::array{3.0}), 1);
  EXPECT_EQ(longest_run(std::array{1.0, 2.0, 1.0, 2.0}), 1);
  EXPECT_EQ(longest_run(std::array{1.0, 1.0, 2.0, 2.0, 2.0, 1.0}), 3);
  EXPECT_EQ(longest_run(std::array{2.0, 1.0, 1.0}), 2);
}

TEST(QualityFlags, OfRunsAreOfThoseLongerThanTheBound) {
  const std::vector<AnswerRow> rows = rated_as({"2", "3", "3", "3", "4", "4"});
  EXPECT_EQ(reasons_by(longstring(3), rows), "");
  EXPECT_EQ(reasons_by(longstring(2), rows), "longest run of equal answers 3 > 2");
}

TEST(QualityFlags, OfRunsFollowTheOrderOfTrialsAndCompareNumbers) {
  std::vector<AnswerRow> rows = {rated(3, "3.0"), rated(1, "3"), rated(2, "3"), rated(4, "1")};
  EXPECT_EQ(reasons_by(longstring(2), rows), "longest run of equal answers 3 > 2");
  rows[2].trial = 5;  // now 3, 3, 1, 3
  EXPECT_EQ(reasons_by(longstring(2), rows), "");
}

TEST(QualityFlags, OfRunsPassOverWhatIsNoAnalysedAnswerOnAScale) {
  for (int kind = 0; kind < 5; ++kind) {
    std::vector<AnswerRow> rows = rated_as({"3", "1", "3", "3"});
    AnswerRow& other = rows[1];
    if (kind == 0) other.is_practice = true;
    if (kind == 1) other.is_warmup = true;
    if (kind == 2) other.is_check = true;
    if (kind == 3) other.kind = attention_kind;
    if (kind == 4) {
      other.kind = emotion_form.name;
      other.item = emotion_form.item;
      other.value_raw = "sad";
    }
    EXPECT_EQ(reasons_by(longstring(2), rows), "longest run of equal answers 3 > 2") << kind;
    other.value_raw = "3";
    EXPECT_EQ(reasons_by(longstring(3), rows), "") << kind << ": it must not extend the run";
  }
}

TEST(QualityFlags, MeasureTheDeviationBetweenAnswers) {
  EXPECT_TRUE(std::isnan(sample_deviation({})));
  EXPECT_TRUE(std::isnan(sample_deviation(std::array{3.0})));
  EXPECT_EQ(sample_deviation(std::array{3.0, 3.0, 3.0}), 0.0);
  EXPECT_EQ(sample_deviation(std::array{1.0, 3.0, 5.0}), 2.0);
  // Of 2, 4, 4, 4, 5, 5, 7, 9 the squares about the mean of 5 sum up to 32.
  EXPECT_DOUBLE_EQ(sample_deviation(std::array{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}),
                   std::sqrt(32.0 / 7.0));
}

TEST(QualityFlags, OfDeviationsAreBelowTheBoundNotAtIt) {
  const std::vector<AnswerRow> rows = rated_as({"1", "3", "5"});
  EXPECT_EQ(reasons_by(deviation(2.0), rows), "");
  EXPECT_EQ(reasons_by(deviation(2.00001), rows), "standard deviation of answers 2 < 2.00001");
  // 0.4 = √(4 · 1 · 24 / (25 · 24)) / 1, with 1 of 25 … on points: 24 threes and a five.
  std::vector<std::string> nearly_all(24, "3");
  nearly_all.emplace_back("5");
  EXPECT_EQ(reasons_by(deviation(0.4), rated_as(nearly_all)), "");
  nearly_all.emplace_back("3");
  EXPECT_EQ(reasons_by(deviation(0.4), rated_as(nearly_all)),
            "standard deviation of answers 0.392 < 0.4");
}

TEST(QualityFlags, OfDeviationsNeedTwoAnswers) {
  EXPECT_EQ(reasons_by(deviation(1.0), rated_as({"3"})), "");
  EXPECT_EQ(reasons_by(deviation(1.0), rated_as({"3", "3"})),
            "standard deviation of answers 0 < 1");
}

TEST(QualityFlags, OfScalesAreNoneWhereAnswersAreWords) {
  Questionnaire questionnaire;
  questionnaire.answer.words = true;
  questionnaire.analysis.quality = {.min_rt_ms = 250.0, .max_longstring = 1, .min_sd = 9.0};
  std::vector<AnswerRow> rows = rated_as({"1", "1", "1"});
  rows[0].rt_ms = 1.0;
  const QualityFlags flags = quality_flags(questionnaire, rows);
  EXPECT_TRUE(flags.participants.empty());
  EXPECT_EQ(flags.answers.size(), 1u);
}

TEST(QualityFlags, OfAttentionComeFirstAndAlwaysExclude) {
  QualityFlags flags = flags_by(deviation(1.0), rated_as({"3", "3"}));
  add_failed_attention({{.participant = "p001", .checks = 5, .passed = 1, .is_excluded = true},
                        {.participant = "p002", .checks = 5, .passed = 4}},
                       {.max_failed_checks = 1}, flags);
  EXPECT_EQ(reasons_text(flags.of_participant("p001")),
            "failed attention checks 4 > 1; standard deviation of answers 0 < 1");
  EXPECT_TRUE(flags.of_participant("p002").empty());
  flags.rules.flagged = FlaggedAnswers::kept;
  EXPECT_TRUE(flags.leaves_out("p001"));
}

TEST(QualityFlags, LeaveNothingOutWhereTheyAreKept) {
  std::vector<AnswerRow> rows = rated_as({"3", "3"});
  rows[0].rt_ms = 1.0;
  QualityFlags flags = flags_by({.min_rt_ms = 250.0, .min_sd = 1.0}, rows);
  EXPECT_TRUE(flags.leaves_out("p001"));
  EXPECT_TRUE(flags.leaves_out(std::size_t{0}));
  EXPECT_FALSE(flags.leaves_out(std::size_t{1}));
  flags.rules.flagged = FlaggedAnswers::kept;
  EXPECT_FALSE(flags.leaves_out("p001"));
  EXPECT_FALSE(flags.leaves_out(std::size_t{0}));
}

/// Random answers of several people, also to practice, checks and repeated stimuli.
std::vector<AnswerRow> random_answers(std::mt19937& random) {
  Manifest manifest = two_emotion_study(5, random());
  manifest.questionnaire->repeated = 1;
  manifest.questionnaire->attention_every = 3;
  std::vector<AnswerRow> rows = answers_to(manifest);
  std::uniform_int_distribution<int> any(0, 9);
  for (AnswerRow& row : rows) {
    row.value_raw = std::to_string(any(random) / 4);
    row.rt_ms = 100.0 * any(random);
    row.blur_ms = 1000.0 * any(random);
  }
  return rows;
}

QualityRules random_rules(std::mt19937& random) {
  std::uniform_int_distribution<int> any(0, 9);
  QualityRules rules;
  if (any(random) < 5) rules.min_rt_ms = 100.0 * any(random);
  if (any(random) < 5) rules.max_rt_ms = 100.0 * any(random);
  if (any(random) < 5) rules.max_blur_ms = 1000.0 * any(random);
  if (any(random) < 5) rules.max_longstring = 1 + any(random) / 2;
  if (any(random) < 5) rules.min_sd = 0.1 * any(random);
  return rules;
}

bool has_all(const std::vector<QualityFlag>& flags, const std::vector<QualityFlag>& all) {
  return std::ranges::all_of(flags, [&](const QualityFlag& flag) {
    return std::ranges::count(all, flag.reason, &QualityFlag::reason) == 1;
  });
}

/// Sets a rule that is not set.
void add_rule(QualityRules& rules, const QualityRules& more) {
  const auto add = [](auto& rule, const auto& value) {
    if (!rule) rule = value;
  };
  add(rules.min_rt_ms, more.min_rt_ms);
  add(rules.max_rt_ms, more.max_rt_ms);
  add(rules.max_blur_ms, more.max_blur_ms);
  add(rules.max_longstring, more.max_longstring);
  add(rules.min_sd, more.min_sd);
}

TEST(QualityFlags, AreNeverFewerWithAnotherRule) {
  std::mt19937 random(40);
  std::size_t flagged = 0;
  for (int study = 0; study < 60; ++study) {
    const std::vector<AnswerRow> rows = random_answers(random);
    QualityRules rules = random_rules(random);
    const QualityFlags few = flags_by(rules, rows);
    add_rule(rules, random_rules(random));
    const QualityFlags more = flags_by(rules, rows);
    for (const auto& [row, flags] : few.answers) {
      EXPECT_TRUE(rows[row].counts());
      EXPECT_TRUE(has_all(flags, more.of_answer(row))) << study;
    }
    for (const auto& [participant, flags] : few.participants)
      EXPECT_TRUE(has_all(flags, more.of_participant(participant))) << study;
    flagged += few.answers.size() + few.participants.size();
  }
  EXPECT_GT(flagged, 500u);
}

// Files of answers hold one participant each, and may come in any order.
TEST(QualityFlags, DoNotDependOnTheOrderOfParticipants) {
  std::mt19937 random(41);
  for (int study = 0; study < 30; ++study) {
    std::vector<AnswerRow> rows = random_answers(random);
    const QualityRules rules = random_rules(random);
    const QualityFlags before = flags_by(rules, rows);
    std::ranges::stable_sort(rows, std::greater<>(), &AnswerRow::participant);
    const QualityFlags after = flags_by(rules, rows);
    ASSERT_EQ(after.answers.size(), before.answers.size());
    ASSERT_EQ(after.participants.size(), before.participants.size());
    for (const auto& [participant, flags] : before.participants)
      EXPECT_EQ(reasons_text(after.of_participant(participant)), reasons_text(flags));
  }
}

}  // namespace
}  // namespace mien::pipeline
