#include "pipeline/study/questionnaire/rating_spread.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {
namespace {

TEST(RatingSpread, OfACompleteTableIsThatOfTheAnalysisOfVariance) {
  // Shrout and Fleiss 1979, six targets and four judges: mean squares 11.24 (targets), 32.49
  // (judges), 1.02 (left). Here judges are participants, targets stimuli.
  const double table[6][4] = {{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                              {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
  std::vector<CrossedRating> ratings;
  for (int target = 0; target < 6; ++target) {
    for (int judge = 0; judge < 4; ++judge)
      ratings.push_back({judge, target, table[target][judge]});
  }
  const RatingSpread spread = spread_of(ratings);
  EXPECT_NEAR(spread.residual * spread.residual, 1.02, 0.005);
  EXPECT_NEAR(spread.stimulus * spread.stimulus, (11.24 - 1.02) / 4, 0.005);
  EXPECT_NEAR(spread.participant * spread.participant, (32.49 - 1.02) / 6, 0.005);
}

TEST(RatingSpread, IsFoundAgainWhereEachRatesAPart) {
  Answers answers;
  for (int person = 0; person < 300; ++person) {
    const double lean = 0.6 * normal(3, "person/" + std::to_string(person));
    for (int thing = 0; thing < 60; ++thing) {
      if ((person * 7 + thing * 13) % 3 == 0) continue;
      const std::string name = std::to_string(thing);
      const double rest = normal(3, "rest/" + std::to_string(person) + "/" + name);
      answers.answers.push_back({std::to_string(person), name, "sad-happy",
                                 lean + 0.5 * normal(3, "thing/" + name) + rest});
      answers.answers.push_back({std::to_string(person), name, "weak-strong", 0.4 * rest});
    }
  }
  const std::vector<ScaleSpread> spreads = spreads_of(answers);
  ASSERT_EQ(spreads.size(), 2u);
  EXPECT_EQ(spreads[0].scale, "sad-happy");
  EXPECT_EQ(spreads[1].scale, "weak-strong");
  EXPECT_NEAR(spreads[1].spread.residual, 0.4, 0.012);
  EXPECT_LT(spreads[1].spread.participant, 0.05);
  const RatingSpread& spread = spreads[0].spread;
  EXPECT_NEAR(spread.participant, 0.6, 0.08);
  EXPECT_NEAR(spread.stimulus, 0.5, 0.15);
  EXPECT_NEAR(spread.residual, 1.0, 0.03);
}

TEST(RatingSpread, IsRefusedWhereNobodyCouldTell) {
  EXPECT_THROW(spread_of(std::vector<CrossedRating>{{0, 0, 1.0}, {0, 1, 2.0}}), Error);
  EXPECT_THROW(spread_of(std::vector<CrossedRating>{{0, 0, 1.0}, {1, 1, 2.0}}), Error);
  EXPECT_THROW(spreads_of(Answers{{{"", "a", "sad-happy", 1.0}}}), Error);
  EXPECT_THROW(spreads_of(Answers{}), Error);
}

}  // namespace
}  // namespace mien::pipeline
