#include "pipeline/manifest/ratings/answers/study_answers.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {
namespace {

using Rules = AnswerRules;

ScaleSet studied_scales() {
  ScaleSet set;
  set.scales.push_back({.id = "slow-fast", .low = "slow", .high = "fast"});
  set.scales.push_back({.id = "open", .low = "closed", .high = "open", .least = -3, .most = 3});
  return set;
}

const std::vector<RatedExample> studied_examples = {{"a", "walk_a"}, {"b", "walk_b"}};

StudyAnswers read(const std::string& csv, const AnswerRules& rules = {}) {
  return study_answers(parse_csv(csv, "x.csv"), studied_scales(), studied_examples, rules);
}

std::string study_refusal(const std::string& csv, const AnswerRules& rules = {}) {
  try {
    read(csv, rules);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::vector<std::string> notes(const StudyAnswers& study) {
  std::vector<std::string> lines;
  for (const StudyWarning& warning : study.warnings) {
    lines.push_back(warning.kind + " " + to_string(warning.place) + " " + warning.text);
  }
  return lines;
}

constexpr const char* study_header = "participant,stimulus,scale,value\n";

const std::string clean = std::string(study_header) +
                          "p,a,slow-fast,1\np,b,slow-fast,-1\np,a,open,0\np,b,open,3\n"
                          "q,walk_a,slow-fast,2\nq,b,slow-fast,-2\nq,a,open,1\nq,b,open,3\n";

TEST(StudyAnswers, AreReadWithTheirPlacesAndExtraColumns) {
  const StudyAnswers study = read(
      "comment,order,value,rt_ms,scale,stimulus,participant,colour\n"
      "\"hm, well\",2,1,830.5,slow-fast,walk_a,p,red\n,,NA,,open,a,p,red\n");
  ASSERT_EQ(study.answers.size(), 1u);
  const StudyAnswer& answer = study.answers[0];
  EXPECT_EQ(answer.stimulus, "a");
  EXPECT_EQ(answer.scale, "slow-fast");
  EXPECT_EQ(answer.value, 1.0);
  EXPECT_EQ(answer.rt_ms, 830.5);
  EXPECT_EQ(answer.order, 2.0);
  EXPECT_EQ(answer.comment, "hm, well");
  EXPECT_EQ(to_string(answer.place), "x.csv:2:14");
  EXPECT_FALSE(study.simulated);
  EXPECT_TRUE(read("participant,stimulus,scale,value,simulated\np,a,open,1,1\n").simulated);
}

TEST(StudyAnswers, CompleteOnesAreToldNothingAbout) {
  const StudyAnswers study = read(clean);
  EXPECT_EQ(study.answers.size(), 8u);
  EXPECT_TRUE(study.warnings.empty()) << notes(study).front();
  EXPECT_EQ(study.plain().answers[4].stimulus, "a");
}

TEST(StudyAnswers, RepeatedOnesAreSettledByTheRule) {
  const std::string csv = clean + "p,a,slow-fast,-2\n";
  EXPECT_EQ(study_refusal(csv),
            "x.csv:10:15: a second answer of participant \"p\" about \"a\" on \"slow-fast\"; keep "
            "one of them, or choose with --repeated first, last or mean");
  const auto value = [&](Rules::Repeated rule) { return read(csv, {.repeated = rule}); };
  EXPECT_EQ(value(Rules::Repeated::first).answers[0].value, 1.0);
  EXPECT_EQ(value(Rules::Repeated::last).answers[0].value, -2.0);
  EXPECT_EQ(value(Rules::Repeated::mean).answers[0].value, -0.5);
  EXPECT_EQ(value(Rules::Repeated::mean).answers.size(), 8u);
  EXPECT_EQ(
      notes(value(Rules::Repeated::last)),
      std::vector<std::string>{"repeated x.csv:10:15 a second answer of participant \"p\" about "
                               "\"a\" on \"slow-fast\" (the other in line 2): the last is used"});
}

TEST(StudyAnswers, FirstAndLastGoByTheOrderOfAnswering) {
  const std::string csv =
      "participant,stimulus,scale,value,order\np,a,open,1,9\np,a,open,2,4\np,a,open,3,6\n";
  EXPECT_EQ(read(csv, {.repeated = Rules::Repeated::first}).answers[0].value, 2.0);
  EXPECT_EQ(read(csv, {.repeated = Rules::Repeated::last}).answers[0].value, 1.0);
  EXPECT_EQ(read(csv, {.repeated = Rules::Repeated::mean}).answers[0].value, 2.0);
}

TEST(StudyAnswers, OfManyUnknownNamesTheFirstAreTold) {
  std::string csv = clean;
  for (int i = 9; i > 0; --i) csv += "p,other-" + std::to_string(i) + ",open,1\n";
  csv += "q,other-1,open,1\n";
  const std::string told_faults = study_refusal(csv);
  EXPECT_EQ(std::ranges::count(told_faults, '\n'), 5);
  EXPECT_NE(told_faults.find("x.csv:14:3: unknown stimulus \"other-5\" (1 row); "),
            std::string::npos)
      << told_faults;
  EXPECT_TRUE(told_faults.ends_with(
      "\nx.csv:15:3: and 4 more unknown stimuli (5 rows); check that the file is about these "
      "examples and scales (--unknown ignore leaves them out)"))
      << told_faults;
  // warnings.csv has room for all.
  EXPECT_EQ(notes(read(csv, {.unknown = Rules::Unknown::ignore})).size(), 9u);
  EXPECT_EQ(notes(read(csv, {.unknown = Rules::Unknown::ignore, .plain = true})).back(),
            "unknown-stimulus x.csv:15:3 and 4 more unknown stimuli (5 rows) excluded");
}

TEST(StudyAnswers, UnknownNamesAreToldOnceWithTheirRows) {
  const std::string csv = clean + "p,c,open,1\nq,c,open,1\np,a,opne,1\n";
  EXPECT_EQ(study_refusal(csv),
            "x.csv:10:3: unknown stimulus \"c\" (2 rows); did you mean \"a\"? (--unknown "
            "ignore leaves it out)\nx.csv:12:5: unknown scale \"opne\" (1 row); did you mean "
            "\"open\"? (--unknown ignore leaves it out)");
  const StudyAnswers study = read(csv, {.unknown = Rules::Unknown::ignore});
  EXPECT_EQ(study.answers.size(), 8u);
  EXPECT_EQ(notes(study),
            (std::vector<std::string>{
                "unknown-stimulus x.csv:10:3 unknown stimulus \"c\" (2 rows) excluded",
                "unknown-scale x.csv:12:5 unknown scale \"opne\" (1 row) excluded"}));
}

TEST(StudyAnswers, MissingOnesAreToldOrRefused) {
  // p left one value empty, q saw only a and skipped a scale, r and s saw all.
  const std::string csv = std::string(study_header) +
                          "p,a,slow-fast,\np,b,slow-fast,-1\np,a,open,0\np,b,open,3\n"
                          "q,a,open,1\n"
                          "r,a,slow-fast,1\nr,b,slow-fast,2\nr,a,open,1\nr,b,open,3\n";
  const std::vector<std::string> expected = {
      "missing x.csv:2:15 no value of participant \"p\" about \"a\" on \"slow-fast\"",
      "missing x.csv:6:10 participant \"q\" did not answer about \"b\"",
      "missing x.csv:6:10 participant \"q\" did not answer about \"a\" on \"slow-fast\""};
  EXPECT_EQ(notes(read(csv)), expected);
  EXPECT_EQ(read(csv).answers.size(), 8u);
  EXPECT_EQ(study_refusal(csv, {.missing = Rules::Missing::refuse}),
            "x.csv:2:15: no value of participant \"p\" about \"a\" on \"slow-fast\"; complete it, "
            "or use --missing ignore\n"
            "x.csv:6:10: participant \"q\" did not answer about \"a\" on \"slow-fast\"; complete "
            "it, or use --missing ignore\n"
            "x.csv:6:10: participant \"q\" did not answer about \"b\"; complete it, or use "
            "--missing ignore");
}

TEST(StudyAnswers, WhereEverybodySawAPartNothingIsMissing) {
  const StudyAnswers study =
      read(std::string(study_header) + "p,a,open,1\nq,b,open,2\nr,a,open,-1\ns,b,open,0\n");
  EXPECT_TRUE(study.warnings.empty()) << notes(study).front();
}

TEST(StudyAnswers, OnAScaleThatNobodyWasAskedOfAStimulusAreNotMissing) {
  const StudyAnswers study = read(std::string(study_header) +
                                  "p,a,open,1\np,a,slow-fast,2\np,b,open,2\n"
                                  "q,a,open,0\nq,a,slow-fast,1\nq,b,open,1\n");
  EXPECT_TRUE(study.warnings.empty()) << notes(study).front();
}

TEST(StudyAnswers, ConstantParticipantsAreToldAndDroppedOnDemand) {
  // −1 … 1 of different ranges: 0.75 of either.
  const std::string csv = clean + "z,a,slow-fast,1\nz,b,slow-fast,1\nz,a,open,1.5\nz,b,open,1.5\n";
  const StudyAnswers kept = read(csv);
  EXPECT_EQ(kept.answers.size(), 12u);
  EXPECT_EQ(notes(kept), std::vector<std::string>{"constant-participant x.csv:10:15 participant "
                                                  "\"z\" gave the same answer 4 times: kept"});
  const StudyAnswers dropped = read(csv, {.constant = Rules::Constant::drop});
  EXPECT_EQ(dropped.answers.size(), 8u);
  EXPECT_NE(notes(dropped).front().find("excluded"), std::string::npos);
}

TEST(StudyAnswers, EveryFaultIsToldAtOnce) {
  EXPECT_EQ(
      study_refusal("participant,stimulus,scale,value,rt_ms\np,a,slow-fast,3,1\np,b,slow-fast,x,1\n"
                    "p,a,open,3,-5\np,b,open,1,soon\n"),
      "x.csv:2:15: 3 is outside the range of \"slow-fast\"; answers go from -2 to 2; state "
      "another range in the scales file\n"
      "x.csv:3:15: \"x\" is not a number; write a finite decimal number\n"
      "x.csv:4:12: -5 ms is not a valid response time; write milliseconds from 0 up, or leave the "
      "field empty\n"
      "x.csv:5:12: \"soon\" is not a number; write a finite decimal number");
  EXPECT_EQ(study_refusal("participant,stimulus,value\np,a,1\n"),
            "x.csv:1:1: there is no column \"scale\"; the columns are participant, stimulus, "
            "value");
}

TEST(StudyAnswers, InWordsAreToBeTurnedIntoAnswersFirst) {
  EXPECT_EQ(study_refusal("participant,language,motion,verb,modifier1\np,english,a,walk,slowly\n"),
            "x.csv:1:1: free-text answers instead of answers on scales; convert them with mien "
            "study words");
}

}  // namespace
}  // namespace mien::pipeline
