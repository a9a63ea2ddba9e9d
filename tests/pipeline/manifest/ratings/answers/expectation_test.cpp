#include "pipeline/manifest/ratings/answers/expectation.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

/// Participants' answers on a scale of −2 … 2, an example after the other.
Answers answers_on(const std::string& scale, const std::vector<std::vector<double>>& by_example) {
  Answers answers;
  for (std::size_t e = 0; e < by_example.size(); ++e) {
    for (std::size_t p = 0; p < by_example[e].size(); ++p)
      answers.answers.push_back({"p" + std::to_string(p),
                                 std::string(1, static_cast<char>('a' + e)), scale,
                                 by_example[e][p]});
  }
  return answers;
}

const std::vector<RatedExample> three_examples = {{"a", ""}, {"b", ""}, {"c", ""}};

ExpectationCheck check(const Expectation& expectation, const Answers& answers) {
  const ScaleSet scales = builtin_scales();
  const ParameterTable table =
      parameter_table(impressions_of(answers, scales, three_examples), scales);
  return check_expectations({expectation}, {table, three_examples, answers, scales}).at(0);
}

TEST(Expectation, HoldsWhereEachExampleIsAboveTheOneBefore) {
  const ExpectationCheck result =
      check({"slow-fast", {"a", "b", "c"}},
            answers_on("slow-fast", {{-2, -1, -2, -1}, {0, 0, 0, 1}, {2, 2, 1, 2}}));
  EXPECT_TRUE(result.holds());
  EXPECT_TRUE(result.is_certain());
  EXPECT_EQ(result.steps[0].people, 4);
  EXPECT_DOUBLE_EQ(result.steps[0].difference, 1.75 / 4.0);
  EXPECT_NE(sentence_of(result).find(": as expected"), std::string::npos) << sentence_of(result);
}

TEST(Expectation, TellsWhereItFails) {
  const ExpectationCheck result =
      check({"slow-fast", {"b", "a", "c"}},
            answers_on("slow-fast", {{-2, -1, -2, -1}, {0, 0, 0, 1}, {2, 2, 1, 2}}));
  EXPECT_EQ(result.violated, std::vector<std::size_t>{0});
  EXPECT_NE(sentence_of(result).find("not as expected"), std::string::npos);
}

TEST(Expectation, IsNotMetByEqualValues) {
  const ExpectationCheck result =
      check({"slow-fast", {"a", "b", "c"}}, answers_on("slow-fast", {{0, 1}, {1, 0}, {0, 1}}));
  EXPECT_EQ(result.violated, (std::vector<std::size_t>{0, 1}));
}

// Means in the expected order, and people who do not agree: nothing to stake a study on.
TEST(Expectation, IsNoMoreThanNoiseWherePeopleDisagree) {
  const ExpectationCheck result =
      check({"slow-fast", {"a", "b"}},
            answers_on("slow-fast", {{-2, 2, 0, 1, -1}, {2, -1, 0, -1, 1}, {0, 0, 0, 0, 0}}));
  EXPECT_TRUE(result.holds());
  EXPECT_FALSE(result.is_certain());
  EXPECT_LT(result.steps[0].low, 0.0);
  EXPECT_NE(sentence_of(result).find("not significant"), std::string::npos) << sentence_of(result);
}

TEST(Expectation, OfMeansSaysThatNobodyKnowsTheNoise) {
  Answers means;
  for (const auto& [stimulus, value] : {std::pair{"a", -1.0}, {"b", 0.0}, {"c", 1.0}})
    means.answers.push_back({"", stimulus, "slow-fast", value});
  const ExpectationCheck result = check({"slow-fast", {"a", "b", "c"}}, means);
  EXPECT_TRUE(result.holds());
  EXPECT_FALSE(result.is_certain());
  EXPECT_NE(sentence_of(result).find("(means only)"), std::string::npos);
}

// Each person's mean over the group's scales is what differs, as the parameter is their mean.
TEST(Expectation, OfAGroupTakesEachPersonsMean) {
  Answers answers;
  for (const ScaleGroup& group : builtin_scales().groups) {
    if (group.id != "quickness") continue;
    for (const std::string& scale : group.scales) {
      for (const char* person : {"p1", "p2"}) {
        answers.answers.push_back({person, "a", scale, -1.0});
        answers.answers.push_back({person, "b", scale, 1.0});
        answers.answers.push_back({person, "c", scale, 1.0});
      }
    }
  }
  const ExpectationCheck result = check({"quickness", {"a", "b"}}, answers);
  EXPECT_EQ(result.steps[0].people, 2);
  EXPECT_DOUBLE_EQ(result.steps[0].difference, 0.5);
}

}  // namespace
}  // namespace mien::pipeline
