#include "pipeline/manifest/ratings/answers/impressions.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

ScaleSet two_scales() {
  ScaleSet set;
  set.name = "test";
  set.scales.push_back({.id = "slow-fast", .low = "slow", .high = "fast"});
  set.scales.push_back({.id = "open", .low = "closed", .high = "open", .least = -3, .most = 3});
  set.groups.push_back({.id = "all", .scales = {"slow-fast", "open"}});
  return set;
}

constexpr const char* answers_csv =
    "participant,stimulus,scale,value,rt_s\n"
    "p1,walk_a,slow-fast,2,1.5\n"
    "p2,walk_a,slow-fast,0,1.5\n"
    "p1,b,slow-fast,-2,1\n"
    "p2,b,slow-fast,-2,1\n"
    "p1,walk_a,open,3,1\n"
    "p1,b,open,0,1\n"
    "p9,someone else,open,0,1\n";

const std::vector<RatedExample> examples = {{"a", "walk_a"}, {"b", "walk_b"}};

TEST(Impressions, AreMeansAsSharesOfTheRange) {
  const ScaleSet scales = two_scales();
  const Impressions a =
      impressions_of(parse_answers(answers_csv, "x.csv", scales), scales, examples);
  ASSERT_EQ(a.scales, (std::vector<std::string>{"slow-fast", "open"}));
  EXPECT_DOUBLE_EQ(a.mean(0, 0), 0.75);
  EXPECT_DOUBLE_EQ(a.mean(0, 1), 0.0);
  EXPECT_DOUBLE_EQ(a.mean(1, 0), 1.0);
  EXPECT_DOUBLE_EQ(a.mean(1, 1), 0.5);
  EXPECT_DOUBLE_EQ(a.deviation(0, 0), 0.25);
  EXPECT_EQ(a.count(0, 0), 2);
  EXPECT_FALSE(a.simulated);
}

TEST(Impressions, GroupsAreTheMeansOfTheirMembers) {
  const ScaleSet scales = two_scales();
  const ParameterTable table = parameter_table(
      impressions_of(parse_answers(answers_csv, "x.csv", scales), scales, examples), scales);
  ASSERT_EQ(table.names, (std::vector<std::string>{"all", "slow-fast", "open"}));
  EXPECT_DOUBLE_EQ(table.values(0, 0), (0.75 + 1.0) / 2);
  EXPECT_DOUBLE_EQ(table.values(0, 1), 0.25);
}

TEST(Impressions, ReversingAScaleMirrorsThem) {
  const ScaleSet scales = two_scales();
  Answers answers = parse_answers(answers_csv, "x.csv", scales);
  const Impressions before = impressions_of(answers, scales, examples);
  for (Answer& answer : answers.answers) answer.value = -answer.value;
  const Impressions after = impressions_of(answers, scales, examples);
  EXPECT_LT((before.mean + after.mean - Eigen::MatrixXd::Ones(2, 2)).norm(), 1e-12);
}

TEST(Impressions, MeansWithoutParticipantsAreTaken) {
  const ScaleSet scales = two_scales();
  const Impressions a = impressions_of(
      parse_answers("stimulus,scale,value\na,slow-fast,1\nb,slow-fast,-0.5\n", "m.csv", scales),
      scales, examples);
  EXPECT_DOUBLE_EQ(a.mean(0, 0), 0.75);
  EXPECT_TRUE(std::isnan(a.deviation(0, 0)));
}

TEST(Impressions, NameWhatWasNotRated) {
  const ScaleSet scales = two_scales();
  const Answers answers = parse_answers("stimulus,scale,value\na,slow-fast,1\n", "m.csv", scales);
  try {
    impressions_of(answers, scales, examples);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"b on slow-fast\""), std::string::npos)
        << error.what();
  }
}

struct BadAnswers {
  const char* csv;
  const char* message;
};

class EveryBadAnswer : public testing::TestWithParam<BadAnswers> {};

TEST_P(EveryBadAnswer, IsRefusedWithItsPlace) {
  try {
    parse_answers(GetParam().csv, "a.csv", two_scales());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind(GetParam().message, 0), 0u) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Answers, EveryBadAnswer,
    testing::Values(
        BadAnswers{"stimulus,scale,value\na,slow-fats,1\n",
                   "a.csv:2:3: unknown scale \"slow-fats\" (1 row); did you mean \"slow-fast\"? "
                   "(unknown: ignore leaves it out)"},
        BadAnswers{"stimulus,scale,value\na,slow-fast,3\n",
                   "a.csv:2:13: 3 is outside the range of \"slow-fast\"; answers go from -2 to 2"},
        BadAnswers{"participant,stimulus,scale,value\np,a,open,3\np,a,open,1\n",
                   "a.csv:3:3: a second answer of participant \"p\" about \"a\" on \"open\""},
        BadAnswers{"stimulus,scale,value\na,open,3\na,open,1\n",
                   "a.csv:3:1: a second answer about \"a\" on \"open\"; keep one of them"},
        BadAnswers{"stimulus,scale,value\na,open,-\n", "a.csv:2:8: \"-\" is not a number"},
        BadAnswers{
            "stimulus,scale,value\na,open,4\nb,opne,1\na,slow-fast,x\n",
            "a.csv:2:8: 4 is outside the range of \"open\"; answers go from -3 to 3; state "
            "another range in the scales file\na.csv:3:3: unknown scale \"opne\" (1 row); did "
            "you mean \"open\"? (unknown: ignore leaves it out)\na.csv:4:13: \"x\" is "
            "not a number"},
        BadAnswers{"stimulus,value\na,1\n", "a.csv:1"}));

TEST(Answers, OfAManifestIgnoreOtherColumnsAndNameAnyStimulus) {
  const Answers answers = parse_answers(
      "rt_ms,order,stimulus,scale,value,simulated\nquick,first,whoever,open,1,0\n,,a,open,2,\n",
      "a.csv", two_scales());
  ASSERT_EQ(answers.answers.size(), 2u);
  EXPECT_EQ(answers.answers[0].stimulus, "whoever");
  EXPECT_EQ(answers.answers[1].value, 2.0);
  EXPECT_FALSE(answers.simulated);
}

std::string refusal_of(const std::string& csv, const ScaleSet& scales,
                       const AnswerSubjects& about) {
  try {
    parse_answers(csv, "a.csv", scales, about);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Answers, OfAManifestAreAboutItsExamples) {
  const std::string csv =
      "stimulus,scale,value\nwalk_a,open,1\nwalk_o,open,2\nb,open,0\nc,open,1\nwalk_o,slow-fast,"
      "1\n";
  AnswerSubjects about{.examples = examples, .left_out = {"c"}};
  EXPECT_EQ(refusal_of(csv, two_scales(), about),
            "a.csv:3:1: unknown stimulus \"walk_o\" (2 rows); use one of \"a\", \"b\" (unknown: "
            "ignore leaves it out)");
  about.ignore_unknown = true;
  const Answers answers = parse_answers(csv, "a.csv", two_scales(), about);
  ASSERT_EQ(answers.answers.size(), 2u);
  EXPECT_EQ(answers.answers[0].stimulus, "a");
  EXPECT_EQ(answers.warnings,
            (std::vector<std::string>{"a.csv:3:1: unknown stimulus \"walk_o\" (2 rows) excluded"}));
}

TEST(Answers, InWordsAreAboutTheExamplesToo) {
  const ScaleSet scales =
      read_scales(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests/walking-words.scales.yaml");
  const std::string csv =
      "participant,language,motion,verb,modifier1\n1,english,a,walk,slowly\n1,english,bb,walk,"
      "fast\n";
  AnswerSubjects about{.examples = examples};
  EXPECT_EQ(refusal_of(csv, scales, about),
            "a.csv:3:11: unknown stimulus \"bb\" (1 row); did you mean \"b\"? (unknown: ignore "
            "leaves it out)");
  about.left_out = {"bb"};
  EXPECT_EQ(refusal_of(csv, scales, about), "accepted");
}

TEST(Answers, OfAManifestMayBeMissing) {
  const Answers answers = parse_answers("stimulus,scale,value\na,open,\na,slow-fast,NA\nb,open,1\n",
                                        "a.csv", two_scales());
  ASSERT_EQ(answers.answers.size(), 1u);
  EXPECT_EQ(answers.answers[0].stimulus, "b");
}

}  // namespace
}  // namespace mien::pipeline
