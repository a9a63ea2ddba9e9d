// Simulated people with known worths: they are found, and intervals hold them as often as stated.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/bradley_terry.h"
#include "pipeline/base/statistics/published_pairs.h"
#include "pipeline/base/statistics/worth_bootstrap.h"

namespace mien::pipeline {
namespace {

struct KnownWorth {
  std::vector<double> worth;  ///< sums to zero
  double order = 0.0;
  double tie = -1.0;
};

const std::vector<double> five_worths = {-1.0, -0.5, 0.0, 0.4, 1.1};

using People = std::vector<std::vector<PairCount>>;

/// Answers of people who compare each stimulus with each other, on sides by chance.
People answers_of(const KnownWorth& truth, int people, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto drawn = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  People answers(static_cast<std::size_t>(people));
  for (std::vector<PairCount>& own : answers) {
    for (std::size_t i = 0; i < truth.worth.size(); ++i) {
      for (std::size_t k = i + 1; k < truth.worth.size(); ++k) {
        const bool is_turned = drawn() < 0.5;
        PairCount one{is_turned ? k : i, is_turned ? i : k};
        const double a = std::exp(truth.worth[one.first] + 0.5 * truth.order);
        const double b = std::exp(truth.worth[one.second] - 0.5 * truth.order);
        const double c =
            std::exp(truth.tie + 0.5 * (truth.worth[one.first] + truth.worth[one.second]));
        const double place = drawn() * (a + b + c);
        (place < a ? one.first_wins : place < a + b ? one.second_wins : one.ties) = 1.0;
        own.push_back(one);
      }
    }
  }
  return answers;
}

std::vector<PairCount> all_of(const People& people) {
  std::vector<PairCount> counts;
  for (const std::vector<PairCount>& own : people)
    counts.insert(counts.end(), own.begin(), own.end());
  return counts;
}

TEST(WorthOfSimulatedPeople, IsFoundWithOrderEffectAndTies) {
  const KnownWorth truth{five_worths, 0.3};
  const BradleyTerry fit =
      bradley_terry(all_of(answers_of(truth, 4000, 7)), 5, OrderEffect::estimated);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(fit.worth[i], truth.worth[i], 4.0 * fit.error[i]);
    EXPECT_LT(fit.error[i], 0.02);
  }
  EXPECT_NEAR(fit.order, truth.order, 4.0 * fit.order_error);
  EXPECT_NEAR(fit.tie, truth.tie, 4.0 * fit.tie_error);
}

/// Proportions of intervals that hold the true value.
struct Coverage {
  double profile = 0.0;
  /// The same if each answer is counted three times, as that of people who are sure of themselves
  /// and asked three times: answers that depend on each other.
  double profile_of_repeated = 0.0;
  double bootstrap = 0.0;  ///< also of repeated answers: estimates and resamples are the same
  double bootstrap_order = 0.0;
};

bool holds(const Interval95& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

std::vector<PairCount> three_times(std::vector<PairCount> counts) {
  for (PairCount& one : counts) {
    one.first_wins *= 3.0;
    one.second_wins *= 3.0;
    one.ties *= 3.0;
  }
  return counts;
}

void add_run(const KnownWorth& truth, const People& answers, int resamples, Coverage& found) {
  const std::size_t stimuli = truth.worth.size();
  constexpr OrderEffect order = OrderEffect::estimated;
  const auto profile = [&](const std::vector<PairCount>& counts) {
    return profile_intervals(bradley_terry(counts, stimuli, order), counts, order);
  };
  const auto once = profile(all_of(answers));
  const auto repeated = profile(three_times(all_of(answers)));
  const WorthBootstrap bootstrap = worth_bootstrap(answers, stimuli, order, 1, resamples);
  const double share = 1.0 / static_cast<double>(stimuli);
  for (std::size_t i = 0; i < stimuli; ++i) {
    found.profile += holds(once[i], truth.worth[i]) ? share : 0.0;
    found.profile_of_repeated += holds(repeated[i], truth.worth[i]) ? share : 0.0;
    found.bootstrap += holds(bootstrap.worth[i], truth.worth[i]) ? share : 0.0;
  }
  found.bootstrap_order += holds(bootstrap.order, truth.order) ? 1.0 : 0.0;
}

void expect_coverage(double share, const char* what) {
  ::testing::Test::RecordProperty(what, std::to_string(share));
  EXPECT_GE(share, 0.90) << what;
  EXPECT_LE(share, 0.98) << what;
}

void expect_stated_coverage(int runs, int resamples) {
  const KnownWorth truth{five_worths, 0.3};
  Coverage found;
  for (int run = 0; run < runs; ++run)
    add_run(truth, answers_of(truth, 30, 100 + static_cast<std::uint64_t>(run)), resamples, found);
  expect_coverage(found.profile / runs, "profile");
  expect_coverage(found.bootstrap / runs, "bootstrap");
  expect_coverage(found.bootstrap_order / runs, "order");
  // Repeated answers make intervals too short by √3 if they are treated as independent.
  EXPECT_NEAR(found.profile_of_repeated / runs, 0.74, 0.07);
}

TEST(WorthIntervals, HoldTheWorthAsOftenAsStated) { expect_stated_coverage(60, 199); }

TEST(WorthIntervals, HoldTheWorthAsOftenAsStatedIn500Runs) { expect_stated_coverage(500, 199); }

TEST(EqualWorth, IsRejectedAsOftenAsStatedIfWorthsAreEqual) {
  int equal = 0;
  int order = 0;
  constexpr int runs = 500;
  for (int run = 0; run < runs; ++run) {
    const std::vector<PairCount> counts = all_of(
        answers_of({std::vector<double>(4, 0.0)}, 30, 5000 + static_cast<std::uint64_t>(run)));
    const BradleyTerry fit = bradley_terry(counts, 4, OrderEffect::estimated);
    equal += equal_worth_test(fit, counts, OrderEffect::estimated).p < 0.05 ? 1 : 0;
    order += order_test(fit, bradley_terry(counts, 4, OrderEffect::none)).p < 0.05 ? 1 : 0;
  }
  // 99.9 % of the binomial distribution of 500 with 0.05: 10 … 42.
  EXPECT_GE(equal, 10);
  EXPECT_LE(equal, 42);
  EXPECT_GE(order, 10);
  EXPECT_LE(order, 42);
}

TEST(WorthBootstrap, DependsOnTheSeedOnly) {
  const People people = answers_of({five_worths}, 12, 3);
  const auto first = worth_bootstrap(people, 5, OrderEffect::estimated, 1, 99);
  const auto again = worth_bootstrap(people, 5, OrderEffect::estimated, 1, 99);
  const auto other = worth_bootstrap(people, 5, OrderEffect::estimated, 2, 99);
  EXPECT_EQ(first.worth[1].low, again.worth[1].low);
  EXPECT_EQ(first.order.high, again.order.high);
  EXPECT_NE(first.worth[1].low, other.worth[1].low);
  EXPECT_LT(first.worth[1].low, first.worth[1].high);
}

TEST(WorthBootstrap, HasNoEndsIfManyResamplesHaveNoEstimate) {
  // Only one of ten people ever chose 1: without that one there is no worth.
  People people(10, {{0, 1, 5, 0}});
  people[3] = {{0, 1, 4, 1}};
  const WorthBootstrap found = worth_bootstrap(people, 2, OrderEffect::none, 1);
  EXPECT_NEAR(found.without_estimate, found.resamples * std::pow(0.9, 10), 60.0);
  EXPECT_TRUE(std::isnan(found.worth[0].low));
  EXPECT_TRUE(std::isnan(found.worth[0].high));
  EXPECT_TRUE(std::isnan(found.order.low));
}

TEST(WorthBootstrap, OfPeopleWhoAgreeHasNoWidth) {
  const WorthBootstrap found = worth_bootstrap(People(10, {{0, 1, 3, 1}}), 2, OrderEffect::none, 1);
  EXPECT_NEAR(found.worth[0].low, 0.5 * std::log(3.0), 1e-9);
  EXPECT_NEAR(found.worth[0].high, 0.5 * std::log(3.0), 1e-9);
}

}  // namespace
}  // namespace mien::pipeline
