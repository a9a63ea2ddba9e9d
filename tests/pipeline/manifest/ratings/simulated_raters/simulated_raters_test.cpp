#include "pipeline/manifest/ratings/simulated_raters/simulated_raters.h"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/words/adjective_pairs.h"

namespace mien::pipeline {
namespace {

std::vector<StyledStimulus> three_walks() {
  return {{"calm", {-0.8, 0.1, -0.7, -0.5, 0.1, -0.6, 0.0, 0.3}},
          {"middle", {}},
          {"wild", {0.8, 0.0, 0.9, 0.7, 0.3, 0.8, 0.4, -0.2}}};
}

TEST(NamedRandom, IsUniformAndNormal) {
  double sum = 0.0, squares = 0.0, uniform_sum = 0.0;
  constexpr int draws = 20000;
  for (int i = 0; i < draws; ++i) {
    const std::string name = "draw/" + std::to_string(i);
    const double x = normal(5, name);
    sum += x;
    squares += x * x;
    uniform_sum += uniform(5, name);
  }
  // Five standard errors.
  EXPECT_NEAR(sum / draws, 0.0, 5.0 / std::sqrt(draws));
  EXPECT_NEAR(squares / draws, 1.0, 5.0 * std::sqrt(2.0 / draws));
  EXPECT_NEAR(uniform_sum / draws, 0.5, 5.0 * std::sqrt(1.0 / 12 / draws));
}

TEST(NamedRandom, DependsOnSeedAndName) {
  EXPECT_EQ(uniform(1, "a"), uniform(1, "a"));
  EXPECT_NE(uniform(1, "a"), uniform(2, "a"));
  EXPECT_NE(uniform(1, "a"), uniform(1, "b"));
}

TEST(SimulatedRaters, KnowEveryBuiltInPair) {
  for (const AdjectivePair& pair : adjective_pairs()) {
    Scale scale;
    scale.id = pair.key;
    const StyleProfile loadings = loadings_of(scale);
    double most = 0.0;
    for (double loading : loadings) most = std::max(most, std::abs(loading));
    EXPECT_GE(most, 0.25) << pair.key;
  }
}

TEST(SimulatedRaters, RefuseAScaleTheyCannotKnow) {
  Scale scale;
  scale.id = "extraversion";
  try {
    loadings_of(scale);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"extraversion\""), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("loadings"), std::string::npos);
  }
}

TEST(SimulatedRaters, AnswerOnceEachWithinTheRangeInWholeSteps) {
  const ScaleSet scales = builtin_scales();
  const Answers answers = simulate_answers(three_walks(), scales, {});
  EXPECT_TRUE(answers.simulated);
  EXPECT_EQ(answers.answers.size(), 14u * 3u * 41u);
  std::set<std::string> seen;
  for (const Answer& answer : answers.answers) {
    EXPECT_TRUE(
        seen.insert(answer.participant + "/" + answer.stimulus + "/" + answer.scale).second);
    EXPECT_GE(answer.value, -2.0);
    EXPECT_LE(answer.value, 2.0);
    EXPECT_EQ(answer.value, std::round(answer.value));
  }
}

TEST(SimulatedRaters, OrderWalksAsTheirProfilesSay) {
  const ScaleSet scales = builtin_scales();
  const Answers answers = simulate_answers(three_walks(), scales, {.count = 40});
  const ParameterTable table = parameter_table(
      impressions_of(answers, scales, {{"calm", ""}, {"middle", ""}, {"wild", ""}}), scales);
  for (const char* name : {"slow-fast", "quickness", "activeness", "largeness", "small-large"}) {
    const int row = table.find(name);
    ASSERT_GE(row, 0) << name;
    EXPECT_LT(table.values(row, 0), table.values(row, 1) - 0.05) << name;
    EXPECT_LT(table.values(row, 1), table.values(row, 2) - 0.05) << name;
  }
}

TEST(SimulatedRaters, AnswersDoNotDependOnTheOtherStimuli) {
  const ScaleSet scales = builtin_scales();
  const auto value = [&](const std::vector<StyledStimulus>& stimuli) {
    std::map<std::string, double> values;
    for (const Answer& answer : simulate_answers(stimuli, scales, {.seed = 9}).answers) {
      if (answer.stimulus == "wild") values[answer.participant + answer.scale] = answer.value;
    }
    return values;
  };
  EXPECT_EQ(value(three_walks()), value({three_walks()[2]}));
}

}  // namespace
}  // namespace mien::pipeline
