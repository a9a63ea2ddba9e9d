#include "pipeline/base/statistics/elo_rating.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/bradley_terry.h"
#include "pipeline/base/statistics/published_pairs.h"

namespace mien::pipeline {
namespace {

TEST(EloRating, OfOneComparisonMovesBySixteen) {
  const auto won = elo_ratings({{0, 1, 1, 0}}, 3, 1);
  EXPECT_EQ(won[0].mean, 1516.0);
  EXPECT_EQ(won[1].mean, 1484.0);
  EXPECT_EQ(won[0].deviation, 0.0);
  EXPECT_TRUE(std::isnan(won[2].mean));
  const auto tied = elo_ratings({{0, 1, 0, 0, 1}}, 2, 1);
  EXPECT_EQ(tied[0].mean, 1500.0);
}

TEST(EloRating, OfTwoWinsIsThatOfTheFormula) {
  // 1500 + 16, then + 32·(1 − 1/(1 + 10^(−32/400))) = 32·0.45407…
  const auto won = elo_ratings({{0, 1, 2, 0}}, 2, 1);
  EXPECT_NEAR(won[0].mean, 1516.0 + 32.0 * (1.0 - 1.0 / (1.0 + std::pow(10.0, -0.08))), 1e-9);
}

TEST(EloRating, HasTheSumItBeganWithAndTheOrderOfTheWorths) {
  const auto ratings = elo_ratings(test::citations, 4, 1);
  double sum = 0.0;
  for (const EloRating& one : ratings) sum += one.mean;
  EXPECT_NEAR(sum, 6000.0, 1e-6);
  const BradleyTerry fit = bradley_terry(test::citations, 4, OrderEffect::none);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_EQ(ratings[i].mean < ratings[k].mean, fit.worth[i] < fit.worth[k]);
  EXPECT_GT(ratings[0].deviation, 1.0);
}

TEST(EloRating, DependsOnTheSeedOnly) {
  const auto one = elo_ratings(test::baseball, 7, 1);
  const auto again = elo_ratings(test::baseball, 7, 1);
  const auto other = elo_ratings(test::baseball, 7, 2);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(one[i].mean, again[i].mean);
  EXPECT_NE(one[0].mean, other[0].mean);
}

}  // namespace
}  // namespace mien::pipeline
