#include "pipeline/base/statistics/exact_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(ExactNumber, FindsTheFractionThatADoubleStandsFor) {
  for (int below = 1; below <= 120; ++below) {
    for (int above = -3 * below; above <= 3 * below; ++above) {
      const double value = static_cast<double>(above) / below;
      const ExactNumber number = ExactNumber::of(value);
      ASSERT_TRUE(number.is_exact()) << above << "/" << below;
      EXPECT_EQ(number.value(), value) << above << "/" << below;
      EXPECT_EQ((number * below).value(), above);
    }
  }
  EXPECT_EQ((ExactNumber::of(123.456) * 1000).value(), 123456.0);
}

// The places of a scale are found by additions and products, each of which rounds.
TEST(ExactNumber, ForgivesTheRoundingsOfAPlaceOnAScale) {
  for (int points = 2; points <= 101; ++points) {
    for (int place = 0; place < points; ++place) {
      const double value = -2.0 + 4.0 * (static_cast<double>(place) / (points - 1.0));
      const ExactNumber number = ExactNumber::of(value);
      ASSERT_TRUE(number.is_exact());
      EXPECT_EQ((number * (points - 1)).value(), 4.0 * place - 2.0 * (points - 1));
    }
  }
}

TEST(ExactNumber, AddsDecimalsAsOneDoesByHand) {
  const ExactNumber sum = ExactNumber::of(0.1) + ExactNumber::of(0.2);
  EXPECT_EQ(sum.value(), 0.3);
  EXPECT_NE(0.1 + 0.2, 0.3);  // which is why
  EXPECT_EQ((sum - ExactNumber::of(0.3)).value(), 0.0);
  EXPECT_EQ((ExactNumber::of(1.0) / 3 + ExactNumber::of(2.0) / 3).value(), 1.0);
}

TEST(ExactNumber, SumsToTheSameInAnyOrder) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> places(0, 6);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> values;
    int sum = 0;
    for (int i = 0; i < 29; ++i) {
      const int place = places(random);
      sum += place;
      values.push_back(-2.0 + 4.0 * place / 6.0);
    }
    const double first = exact_mean(values);
    std::ranges::shuffle(values, random);
    EXPECT_EQ(exact_mean(values), first);
    // −2 + 4/6 of the mean place, rounded once.
    EXPECT_EQ(first, static_cast<double>(4 * sum - 12 * 29) / (6 * 29));
  }
}

TEST(ExactNumber, GoesOnAsADoubleWhereThereIsNoFraction) {
  constexpr double pi = 3.14159265358979;
  const ExactNumber number = ExactNumber::of(pi);
  EXPECT_FALSE(number.is_exact());
  EXPECT_EQ(number.value(), pi);
  EXPECT_EQ((number + ExactNumber::of(1.0)).value(), pi + 1.0);
  EXPECT_EQ((-number).value(), -pi);
  EXPECT_TRUE(std::isnan(ExactNumber::of(std::nan("")).value()));
  EXPECT_TRUE(std::isinf(ExactNumber::of(std::numeric_limits<double>::infinity()).value()));
  EXPECT_TRUE(std::isnan(exact_mean({})));
}

TEST(ExactNumber, GoesOnAsADoubleWhere64BitsDoNotHoldIt) {
  ExactNumber grown = ExactNumber::of(1.0);
  for (int below = 2; below < 60; ++below) grown += ExactNumber::of(1.0) / below;
  EXPECT_FALSE(grown.is_exact());
  double sum = 1.0;
  for (int below = 2; below < 60; ++below) sum += 1.0 / below;
  EXPECT_NEAR(grown.value(), sum, 1e-12);
}

}  // namespace
}  // namespace mien::pipeline
