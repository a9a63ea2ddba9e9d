// Expected values were printed by reference/bradley_terry.R with R 4.2.2: glm (log-linear models)
// and, of worths, order effect and ties, BradleyTerry2 1.1.2 and psychotools 0.7.2.

#include "pipeline/base/statistics/bradley_terry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/published_pairs.h"

namespace mien::pipeline {
namespace {

using test::baseball;
using test::citations;
using test::flavours;

constexpr double printed_digits = 1e-6;

void expect_values(const std::vector<double>& values, const std::vector<double>& expected,
                   const char* what) {
  ASSERT_EQ(values.size(), expected.size()) << what;
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], expected[i], printed_digits) << what << " of " << i;
}

void expect_ends(const std::vector<Interval95>& intervals, const std::vector<double>& low,
                 const std::vector<double>& high) {
  std::vector<double> lows;
  std::vector<double> highs;
  for (const Interval95& interval : intervals) {
    lows.push_back(interval.low);
    highs.push_back(interval.high);
  }
  expect_values(lows, low, "lower end");
  expect_values(highs, high, "upper end");
}

TEST(BradleyTerry, MatchesRForCitations) {
  const BradleyTerry fit = bradley_terry(citations, 4, OrderEffect::none);
  ASSERT_TRUE(fit.is_finite);
  expect_values(fit.worth, {0.789922053, -2.159150444, 0.310352283, 1.058876109}, "worth");
  expect_values(fit.error, {0.043330469, 0.072579744, 0.041641016, 0.053046988}, "error");
  EXPECT_NEAR(fit.log_likelihood, -1622.889808828, printed_digits);
  EXPECT_TRUE(std::isnan(fit.order));
  EXPECT_TRUE(std::isnan(fit.tie));
  expect_ends(profile_intervals(fit, citations, OrderEffect::none),
              {0.705630412, -2.305239573, 0.229080112, 0.955700396},
              {0.875524936, -2.020485152, 0.392364124, 1.163689951});
  const LikelihoodRatio equal = equal_worth_test(fit, citations, OrderEffect::none);
  EXPECT_NEAR(equal.chi, 1920.939466239, printed_digits);
  EXPECT_EQ(equal.degrees, 3);
}

/// Errors of λ1 − λ2 and of (λ1 + λ2)/2 − λn.
std::vector<double> errors_of_two_contrasts(const std::vector<PairCount>& counts,
                                            std::size_t stimuli, OrderEffect order) {
  std::vector<std::vector<double>> contrasts(2, std::vector<double>(stimuli, 0.0));
  contrasts[0][0] = 1.0;
  contrasts[0][1] = -1.0;
  contrasts[1][0] = contrasts[1][1] = 0.5;
  contrasts[1].back() = -1.0;
  return contrast_errors(bradley_terry(counts, stimuli, order), counts, order, contrasts);
}

TEST(BradleyTerry, ErrorsOfContrastsMatchR) {
  expect_values(errors_of_two_contrasts(citations, 4, OrderEffect::none),
                {0.102545336, 0.078647003}, "citations");
  expect_values(errors_of_two_contrasts(baseball, 7, OrderEffect::estimated),
                {0.337842535, 0.277805947}, "baseball");
  expect_values(errors_of_two_contrasts(flavours, 9, OrderEffect::none), {0.286818119, 0.226141156},
                "flavours");
  expect_values(errors_of_two_contrasts(flavours, 9, OrderEffect::estimated),
                {0.286953983, 0.395081828}, "flavours with order");
}

TEST(BradleyTerry, MatchesRForTeamsAtHome) {
  const BradleyTerry fit = bradley_terry(baseball, 7, OrderEffect::estimated);
  ASSERT_TRUE(fit.is_finite);
  expect_values(
      fit.worth,
      {-1.078837160, 0.064965493, -0.374142703, 0.396520054, 0.540717834, 0.202503243, 0.248273238},
      "worth");
  expect_values(
      fit.error,
      {0.235428797, 0.203160535, 0.206998322, 0.206843017, 0.209518014, 0.204045008, 0.203922937},
      "error");
  EXPECT_NEAR(fit.order, 0.302260656, printed_digits);
  EXPECT_NEAR(fit.order_error, 0.130943707, printed_digits);
  EXPECT_NEAR(fit.log_likelihood, -169.542871452, printed_digits);
  expect_ends(
      profile_intervals(fit, baseball, OrderEffect::estimated),
      {-1.564600339, -0.334118305, -0.787994223, -0.004498293, 0.136900248, -0.196153703,
       -0.149399323},
      {-0.636253733, 0.465328924, 0.026741093, 0.809599809, 0.961695526, 0.606809773, 0.653094099});
  const LikelihoodRatio equal = equal_worth_test(fit, baseball, OrderEffect::estimated);
  EXPECT_NEAR(equal.chi, 34.873064362, printed_digits);
  EXPECT_EQ(equal.degrees, 6);
  EXPECT_NEAR(equal.p, 4.56052228e-06, 1e-13);
  const LikelihoodRatio order = order_test(fit, bradley_terry(baseball, 7, OrderEffect::none));
  EXPECT_NEAR(order.chi, 5.410609085, printed_digits);
  EXPECT_NEAR(order.p, 0.0200147314, 1e-9);
}

TEST(BradleyTerry, MatchesRWithTies) {
  const BradleyTerry fit = bradley_terry(flavours, 9, OrderEffect::none);
  ASSERT_TRUE(fit.is_finite);
  expect_values(fit.worth,
                {1.113366720, -1.159862826, -2.177383220, 0.715756255, -0.781422714, -1.729480574,
                 2.394833397, 1.118264586, 0.505928376},
                "worth");
  expect_values(fit.error,
                {0.184475924, 0.188158257, 0.223912139, 0.176488507, 0.181730751, 0.204309624,
                 0.229120747, 0.188863540, 0.174116790},
                "error");
  EXPECT_NEAR(fit.tie, -0.144391691, printed_digits);
  EXPECT_NEAR(fit.tie_error, 0.090206302, printed_digits);
  EXPECT_NEAR(fit.log_likelihood, -732.067255448, printed_digits);
  expect_ends(profile_intervals(fit, flavours, OrderEffect::none),
              {0.757381004, -1.535924891, -2.631939744, 0.373334879, -1.142510162, -2.141137022,
               1.961658737, 0.753995589, 0.166752583},
              {1.481451990, -0.797404727, -1.752699421, 1.066019424, -0.429235198, -1.339115975,
               2.861528679, 1.495314757, 0.850114591});
  const LikelihoodRatio equal = equal_worth_test(fit, flavours, OrderEffect::none);
  EXPECT_NEAR(equal.chi, 429.158785188, printed_digits);
  EXPECT_NEAR(equal.p, 1.07659527e-87, 1e-95);
}

TEST(BradleyTerry, MatchesRWithTiesAndOrder) {
  const BradleyTerry fit = bradley_terry(flavours, 9, OrderEffect::estimated);
  ASSERT_TRUE(fit.is_finite);
  expect_values(fit.worth,
                {1.140028070, -1.136187721, -2.162529062, 0.723341362, -0.783130645, -1.742039313,
                 2.385670226, 1.098177113, 0.476669970},
                "worth");
  expect_values(fit.error,
                {0.243478436, 0.234726932, 0.240571289, 0.182316360, 0.182069135, 0.217937109,
                 0.235537938, 0.223415739, 0.246197546},
                "error");
  EXPECT_NEAR(fit.log_likelihood, -732.053155567, printed_digits);
  EXPECT_NEAR(fit.order, 0.033428335, printed_digits);
  EXPECT_NEAR(fit.order_error, 0.199053864, printed_digits);
  EXPECT_NEAR(fit.tie, -0.144366926, printed_digits);
  EXPECT_NEAR(fit.tie_error, 0.090197209, printed_digits);
  expect_ends(profile_intervals(fit, flavours, OrderEffect::estimated),
              {0.666984064, -1.606474373, -2.649214960, 0.370052525, -1.144931179, -2.181964031,
               1.938857419, 0.665832240, -0.003362807},
              {1.622803785, -0.685176931, -1.704635301, 1.085601283, -0.430335145, -1.326694641,
               2.864039535, 1.543002049, 0.963038884});
  EXPECT_NEAR(equal_worth_test(fit, flavours, OrderEffect::estimated).chi, 402.485176183,
              printed_digits);
  const LikelihoodRatio order = order_test(fit, bradley_terry(flavours, 9, OrderEffect::none));
  EXPECT_NEAR(order.chi, 0.028199762, printed_digits);
  EXPECT_NEAR(order.p, 0.866640042, printed_digits);
}

/// The same comparisons with first and second exchanged.
std::vector<PairCount> exchanged(const std::vector<PairCount>& counts) {
  std::vector<PairCount> result;
  for (const PairCount& one : counts)
    result.push_back({one.second, one.first, one.second_wins, one.first_wins, one.ties});
  return result;
}

TEST(BradleyTerry, ExchangingSidesChangesOnlyTheSignOfTheOrderEffect) {
  for (const auto& [counts, stimuli] : {std::pair(baseball, 7), std::pair(flavours, 9)}) {
    const BradleyTerry fit =
        bradley_terry(counts, static_cast<std::size_t>(stimuli), OrderEffect::estimated);
    const BradleyTerry other =
        bradley_terry(exchanged(counts), static_cast<std::size_t>(stimuli), OrderEffect::estimated);
    EXPECT_NEAR(other.order, -fit.order, 1e-9);
    EXPECT_GT(std::abs(fit.order), 0.03);
    EXPECT_NEAR(other.log_likelihood, fit.log_likelihood, 1e-9);
    EXPECT_EQ(std::isnan(other.tie), std::isnan(fit.tie));
    if (!std::isnan(fit.tie)) {
      EXPECT_NEAR(other.tie, fit.tie, 1e-9);
    }
    for (std::size_t i = 0; i < fit.worth.size(); ++i) {
      EXPECT_NEAR(other.worth[i], fit.worth[i], 1e-9);
      EXPECT_NEAR(other.error[i], fit.error[i], 1e-9);
    }
  }
}

TEST(BradleyTerry, OtherNumbersForStimuliChangeNothing) {
  const std::vector<std::size_t> number = {4, 0, 7, 2, 8, 1, 3, 6, 5};
  std::vector<PairCount> renumbered = flavours;
  for (PairCount& one : renumbered) {
    one.first = number[one.first];
    one.second = number[one.second];
  }
  std::ranges::reverse(renumbered);
  const BradleyTerry fit = bradley_terry(flavours, 9, OrderEffect::estimated);
  const BradleyTerry other = bradley_terry(renumbered, 9, OrderEffect::estimated);
  const auto intervals = profile_intervals(fit, flavours, OrderEffect::estimated);
  const auto others = profile_intervals(other, renumbered, OrderEffect::estimated);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(other.worth[number[i]], fit.worth[i], 1e-9);
    EXPECT_NEAR(other.error[number[i]], fit.error[i], 1e-9);
    EXPECT_NEAR(others[number[i]].low, intervals[i].low, 1e-8);
    EXPECT_NEAR(others[number[i]].high, intervals[i].high, 1e-8);
  }
  EXPECT_NEAR(other.order, fit.order, 1e-9);
}

TEST(BradleyTerry, OfTwoStimuliIsTheLogOdds) {
  const BradleyTerry fit = bradley_terry({{0, 1, 30, 10}}, 2, OrderEffect::none);
  EXPECT_NEAR(fit.worth[0] - fit.worth[1], std::log(3.0), 1e-12);
  // Var(log-odds) = 1/30 + 1/10, of which each worth is a half.
  EXPECT_NEAR(fit.error[0], 0.5 * std::sqrt(1.0 / 30.0 + 1.0 / 10.0), 1e-12);
  const BradleyTerry tied = bradley_terry({{0, 1, 30, 10, 20}}, 2, OrderEffect::none);
  EXPECT_NEAR(tied.worth[0] - tied.worth[1], std::log(3.0), 1e-12);
  EXPECT_NEAR(tied.tie, std::log(20.0 / std::sqrt(300.0)), 1e-12);
}

TEST(BradleyTerry, SplitCountsAreTheSameAsTheirSum) {
  std::vector<PairCount> split;
  for (const PairCount& one : citations) {
    split.push_back({one.first, one.second, one.first_wins - 5, 3});
    split.push_back({one.second, one.first, one.second_wins - 3, 5});
  }
  expect_values(bradley_terry(split, 4, OrderEffect::none).worth,
                bradley_terry(citations, 4, OrderEffect::none).worth, "worth");
}

TEST(BradleyTerry, HasNoNumbersWithoutAnswers) {
  for (const OrderEffect order : {OrderEffect::none, OrderEffect::estimated}) {
    EXPECT_TRUE(bradley_terry({}, 0, order).worth.empty());
    const BradleyTerry fit = bradley_terry({}, 3, order);
    EXPECT_TRUE(std::ranges::all_of(fit.worth, [](double w) { return std::isnan(w); }));
    EXPECT_TRUE(std::isnan(fit.order));
    EXPECT_TRUE(std::isnan(equal_worth_test(fit, {}, order).p));
    EXPECT_TRUE(std::isnan(profile_intervals(fit, {}, order)[0].low));
  }
}

TEST(BradleyTerry, WithNothingButTiesHasNoNumbers) {
  const std::vector<PairCount> ties = {{0, 1, 0, 0, 5}, {1, 2, 0, 0, 4}};
  const BradleyTerry fit = bradley_terry(ties, 3, OrderEffect::none);
  EXPECT_FALSE(fit.is_finite);
  EXPECT_TRUE(std::isnan(fit.worth[0]));
  EXPECT_TRUE(std::isnan(fit.tie));
  EXPECT_TRUE(std::isnan(equal_worth_test(fit, ties, OrderEffect::none).p));
}

TEST(BradleyTerry, GivesNoNumberToWhatAlwaysWinsOrLoses) {
  // 3 always wins, 4 always loses; the others are as in `citations` among each other.
  std::vector<PairCount> counts = {{3, 0, 9, 0}, {1, 3, 0, 2}, {0, 4, 3, 0}, {4, 3, 0, 5}};
  std::vector<PairCount> among = {{0, 1, 73, 13}, {0, 2, 49, 32}, {1, 2, 16, 81}};
  counts.insert(counts.end(), among.begin(), among.end());
  const BradleyTerry fit = bradley_terry(counts, 5, OrderEffect::none);
  EXPECT_TRUE(fit.is_finite);
  EXPECT_EQ(fit.groups.records[3], WinRecord::always_won);
  EXPECT_EQ(fit.groups.records[4], WinRecord::always_lost);
  for (const std::size_t i : {3UL, 4UL}) {
    EXPECT_TRUE(std::isnan(fit.worth[i]));
    EXPECT_TRUE(std::isnan(fit.error[i]));
    EXPECT_TRUE(std::isnan(profile_intervals(fit, counts, OrderEffect::none)[i].high));
  }
  const BradleyTerry rest = bradley_terry(among, 3, OrderEffect::none);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(fit.worth[i], rest.worth[i], 1e-9);
    EXPECT_NEAR(fit.error[i], rest.error[i], 1e-9);
  }
  EXPECT_NEAR(fit.log_likelihood, rest.log_likelihood, 1e-9);
  // All of them differ: the test counts what always wins, too.
  const LikelihoodRatio equal = equal_worth_test(fit, counts, OrderEffect::none);
  EXPECT_EQ(equal.degrees, 4);
  EXPECT_NEAR(equal.chi, 2.0 * (rest.log_likelihood + 283.0 * std::log(2.0)), 1e-9);
}

TEST(BradleyTerry, TestsAStimulusThatAlwaysWinsAgainstOneOther) {
  const std::vector<PairCount> counts = {{0, 1, 20, 0}};
  const BradleyTerry fit = bradley_terry(counts, 2, OrderEffect::none);
  EXPECT_TRUE(std::isnan(fit.worth[0]));
  const LikelihoodRatio equal = equal_worth_test(fit, counts, OrderEffect::none);
  EXPECT_NEAR(equal.chi, 40.0 * std::log(2.0), 1e-9);
  EXPECT_EQ(equal.degrees, 1);
}

TEST(BradleyTerry, HasNoOrderEffectThatCannotBeDetermined) {
  // One order only: worth and order cannot be distinguished.
  EXPECT_FALSE(bradley_terry({{0, 1, 6, 4}}, 2, OrderEffect::estimated).is_finite);
  // The first one is always chosen, in a circle and back: the effect is infinite.
  const std::vector<PairCount> first = {{0, 1, 6, 0}, {1, 0, 4, 0}, {1, 2, 5, 0}, {2, 1, 5, 0}};
  EXPECT_FALSE(bradley_terry(first, 3, OrderEffect::estimated).is_finite);
  EXPECT_TRUE(bradley_terry(first, 3, OrderEffect::none).is_finite);
  EXPECT_TRUE(std::isnan(order_test(bradley_terry(first, 3, OrderEffect::estimated),
                                    bradley_terry(first, 3, OrderEffect::none))
                             .p));
}

TEST(BradleyTerry, HasNoMaximumIfATieIsTheOnlyAlternativeToWinning) {
  // P(1 chosen) is estimated as 0: no finite difference.
  EXPECT_FALSE(bradley_terry({{0, 1, 6, 0, 4}}, 2, OrderEffect::none).is_finite);
}

TEST(BradleyTerry, IsFoundForOddsOfALongChain) {
  // Each is chosen 99 of 100 times over the next: worths from 4.5·ln 99 down.
  std::vector<PairCount> chain;
  for (std::size_t i = 0; i + 1 < 10; ++i) chain.push_back({i, i + 1, 99, 1});
  const BradleyTerry fit = bradley_terry(chain, 10, OrderEffect::none);
  ASSERT_TRUE(fit.is_finite);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(fit.worth[i], (4.5 - static_cast<double>(i)) * std::log(99.0), 1e-8);
}

TEST(BradleyTerry, HasGroupsOfItsOwnWhereThingsWereNotComparedWithEachOther) {
  const std::vector<PairCount> counts = {{0, 1, 6, 3}, {2, 3, 4, 8}};
  const BradleyTerry fit = bradley_terry(counts, 5, OrderEffect::none);
  EXPECT_EQ(fit.groups.group, (std::vector<std::size_t>{0, 0, 1, 1, 2}));
  EXPECT_NEAR(fit.worth[0], 0.5 * std::log(2.0), 1e-12);
  EXPECT_NEAR(fit.worth[2], -0.5 * std::log(2.0), 1e-12);
  EXPECT_TRUE(std::isnan(fit.worth[4]));
  EXPECT_EQ(equal_worth_test(fit, counts, OrderEffect::none).degrees, 2);
}

}  // namespace
}  // namespace mien::pipeline
