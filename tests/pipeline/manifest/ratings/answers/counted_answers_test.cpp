#include "pipeline/manifest/ratings/answers/counted_answers.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/manifest/ratings/answers/study_answers.h"

namespace mien::pipeline {
namespace {

ScaleSet questionnaire_scales() {
  ScaleSet set;
  set.scales.push_back({.id = "sad-happy", .low = "sad", .high = "happy"});
  return set;
}

AnswerRow asked(const std::string& participant, int trial, const std::string& stimulus,
                const std::string& value) {
  return {.participant = participant,
          .trial = trial,
          .stimulus = stimulus,
          .item = "sad-happy",
          .value_raw = "1",
          .value = value};
}

/// Two who attend and one who does not.
std::vector<AnswerRow> questionnaire() {
  std::vector<AnswerRow> rows;
  for (const char* participant : {"p1", "p2", "p3"}) {
    rows.push_back(asked(participant, 1, "walk", "2"));
    rows.back().is_practice = true;
    rows.push_back(asked(participant, 2, "walk", "1"));
    rows.back().is_warmup = true;
    rows.push_back(asked(participant, 3, "walk", "-1"));
    rows.push_back(asked(participant, 4, "run", "0.5"));
    rows.push_back(asked(participant, 5, "walk", "2"));
    rows.back().is_check = true;
    for (int trial : {6, 7}) {
      rows.push_back({.participant = participant,
                      .trial = trial,
                      .kind = "attention",
                      .is_check = true,
                      .expected = "1",
                      .passed = participant != std::string("p3")});
    }
  }
  return rows;
}

TEST(CountedAnswers, AreReadAsRatingsOfAManifest) {
  const Answers answers = parse_answers(to_csv(questionnaire()), "a.csv", questionnaire_scales());
  ASSERT_EQ(answers.answers.size(), 4u);
  EXPECT_EQ(answers.answers[0].participant, "p1");
  EXPECT_EQ(answers.answers[0].stimulus, "walk");
  EXPECT_EQ(answers.answers[0].scale, "sad-happy");
  EXPECT_EQ(answers.answers[0].value, -1.0);
  EXPECT_EQ(answers.answers[3].value, 0.5);
  EXPECT_FALSE(answers.simulated);
  ASSERT_EQ(answers.warnings.size(), 1u);
  EXPECT_EQ(answers.warnings[0], "participant \"p3\" is excluded: 0 of 2 attention checks passed");
}

TEST(CountedAnswers, OfEarlierVersionsAreTheSameWithAWarning) {
  const std::string now = to_csv(questionnaire());
  std::string former = now;
  former.replace(former.find("is_check"), 8, "is_catch");
  const std::string warning = "is_catch: now called is_check; rename the column";

  const Answers rated = parse_answers(former, "in/a.csv", questionnaire_scales());
  EXPECT_EQ(to_csv(rated), to_csv(parse_answers(now, "in/a.csv", questionnaire_scales())));
  ASSERT_EQ(rated.warnings.size(), 2u);
  EXPECT_EQ(rated.warnings[0], "a.csv:1:142: " + warning);

  const auto studied = [](const std::string& csv) {
    return study_answers(parse_csv(csv, "a.csv"), questionnaire_scales(),
                         {{"walk", ""}, {"run", ""}}, {});
  };
  const StudyAnswers study = studied(former), same = studied(now);
  EXPECT_EQ(to_csv(study.plain()), to_csv(same.plain()));
  ASSERT_EQ(study.warnings.size(), same.warnings.size() + 1);
  EXPECT_EQ(std::ranges::count(study.warnings, warning, &StudyWarning::text), 1);
}

TEST(CountedAnswers, OfASimulationAreMarked) {
  std::vector<AnswerRow> rows = questionnaire();
  for (AnswerRow& row : rows) row.simulated = true;
  EXPECT_TRUE(parse_answers(to_csv(rows), "a.csv", questionnaire_scales()).simulated);
}

TEST(CountedAnswers, AreAnalysedAsTheyAre) {
  const StudyAnswers study = study_answers(parse_csv(to_csv(questionnaire()), "a.csv"),
                                           questionnaire_scales(), {{"walk", ""}, {"run", ""}}, {});
  EXPECT_EQ(study.answers.size(), 4u);
}

TEST(CountedAnswers, KeepTheirPlacesInFaults) {
  std::vector<AnswerRow> rows = questionnaire();
  rows[2].value = "7";
  try {
    parse_answers(to_csv(rows), "a.csv", questionnaire_scales());
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a.csv:4:"), std::string::npos) << error.what();
  }
}

TEST(CountedAnswers, ThatAreNoneAreRefused) {
  std::vector<AnswerRow> rows = questionnaire();
  rows.resize(2);
  try {
    parse_answers(to_csv(rows), "a.csv", questionnaire_scales());
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no ratings to analyse"), std::string::npos);
  }
}

}  // namespace
}  // namespace mien::pipeline
