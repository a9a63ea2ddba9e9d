#include "pipeline/base/adaptive/psychometric_bootstrap.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

/// Two-alternative trials of an observer with threshold (0.75) near 1.
const PsychometricFunction true_observer = {Sigmoid::logistic, 1.0, 0.9, 0.5, 0.02};
constexpr RateRange no_rate = {0.0, 0.0};

std::vector<LevelCount> answers_of(const PsychometricFunction& truth,
                                   const std::vector<double>& levels, int trials,
                                   std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<LevelCount> counts;
  for (const double level : levels) {
    const double probability = answer_probability(truth, level).positive;
    LevelCount& count = counts.emplace_back(LevelCount{level, trials, 0});
    for (int i = 0; i < trials; ++i)
      count.positive += static_cast<double>(random() >> 11) * 0x1p-53 < probability ? 1 : 0;
  }
  return counts;
}

const std::vector<double> six_levels = {-1.5, 0.0, 0.8, 1.6, 2.5, 4.0};

TEST(PsychometricBootstrap, DependsOnTheSeedOnly) {
  const auto counts = answers_of(true_observer, six_levels, 40, 1);
  const PsychometricFit fit = psychometric_fit(counts, {});
  const BootstrapRequest request{0.75, 0.9, 99};
  const auto first = psychometric_bootstrap(fit, counts, {}, request, 1);
  const auto again = psychometric_bootstrap(fit, counts, {}, request, 1);
  const auto other = psychometric_bootstrap(fit, counts, {}, request, 2);
  EXPECT_EQ(first.threshold.low, again.threshold.low);
  EXPECT_EQ(first.deviance_p, again.deviance_p);
  EXPECT_NE(first.threshold.low, other.threshold.low);
}

TEST(PsychometricBootstrap, HasTheSpreadOfTheInformationIfThereAreManyTrials) {
  // Without guesses and lapses the information of location and width is that of logistic
  // regression; at the symmetric design the location's variance is β²/Σ n p(1 − p).
  const PsychometricFunction truth{Sigmoid::logistic, 0.0, 1.0, 0.0, 0.0};
  const PsychometricModel model{Sigmoid::logistic, no_rate, no_rate};
  std::vector<LevelCount> counts;
  double information = 0.0;
  for (const double level : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    const auto [positive, negative] = answer_probability(truth, level);
    counts.push_back({level, 2000, static_cast<int>(std::lround(2000 * positive))});
    information += 2000 * positive * negative;
  }
  const PsychometricFit fit = psychometric_fit(counts, model);
  const auto found = psychometric_bootstrap(fit, counts, model, {0.5, 0.95, 999}, 3);
  const double reach = 1.959964 / std::sqrt(information);
  EXPECT_NEAR(found.location.low, -reach, 0.12 * reach);
  EXPECT_NEAR(found.location.high, reach, 0.12 * reach);
  EXPECT_EQ(found.location.low, found.threshold.low);
  EXPECT_LT(found.width.low, fit.function.width);
  EXPECT_GT(found.width.high, fit.function.width);
  EXPECT_LT(found.slope.low, 0.25 / fit.function.width);
  EXPECT_GT(found.slope.high, 0.25 / fit.function.width);
  EXPECT_NEAR(found.slope.low * found.width.high, 0.25, 1e-9);
  const auto higher = psychometric_bootstrap(fit, counts, model, {0.9, 0.95, 99}, 3);
  EXPECT_NEAR(higher.slope.low * higher.width.high, 0.9 * 0.1, 1e-9);
  EXPECT_GT(higher.threshold.low, fit.function.location + 1.9 * fit.function.width);
  EXPECT_EQ(found.lapse.low, 0.0);
  EXPECT_EQ(found.lapse.high, 0.0);
  EXPECT_EQ(found.steps + found.without_estimate, 0);
}

TEST(PsychometricBootstrap, HasWiderIntervalsForMoreConfidence) {
  const auto counts = answers_of(true_observer, six_levels, 40, 1);
  const PsychometricFit fit = psychometric_fit(counts, {});
  const auto wide = psychometric_bootstrap(fit, counts, {}, {0.75, 0.95, 199}, 1);
  const auto narrow = psychometric_bootstrap(fit, counts, {}, {0.75, 0.5, 199}, 1);
  EXPECT_LT(wide.threshold.low, narrow.threshold.low);
  EXPECT_GT(wide.threshold.high, narrow.threshold.high);
  // 20 resamples do not have a rank of 2.5 %.
  EXPECT_TRUE(std::isnan(psychometric_bootstrap(fit, counts, {}, {0.75, 0.95, 20}, 1).width.low));
}

TEST(PsychometricBootstrap, HasNoEndsIfManyResamplesHaveNone) {
  const std::vector<LevelCount> few = {{0.0, 6, 3}, {1.0, 6, 4}, {2.0, 6, 5}};
  const PsychometricModel model{Sigmoid::logistic, {0.5, 0.5}, no_rate};
  const PsychometricFit fit = psychometric_fit(few, model);
  ASSERT_EQ(fit.problem, FitProblem::none);
  const auto found = psychometric_bootstrap(fit, few, model, {}, 1);
  EXPECT_GT(found.steps, 50);
  EXPECT_GT(found.without_estimate, 100);
  EXPECT_TRUE(std::isnan(found.threshold.low));
  EXPECT_TRUE(std::isnan(found.threshold.high));
  EXPECT_TRUE(std::isnan(found.slope.high));
  const PsychometricFit none = psychometric_fit({{0.0, 6, 6}, {1.0, 6, 6}}, model);
  EXPECT_TRUE(std::isnan(psychometric_bootstrap(none, few, model, {}, 1).deviance_p));
}

TEST(PsychometricBootstrap, RejectsAFunctionThatDoesNotFit) {
  // A plateau in the middle, which no sigmoid has.
  const std::vector<LevelCount> plateau = {{0.0, 60, 5},  {1.0, 60, 30}, {2.0, 60, 31},
                                           {3.0, 60, 29}, {4.0, 60, 32}, {5.0, 60, 55}};
  const PsychometricModel model{Sigmoid::logistic, no_rate, no_rate};
  const auto found =
      psychometric_bootstrap(psychometric_fit(plateau, model), plateau, model, {0.5, 0.95, 199}, 1);
  EXPECT_EQ(found.deviance_p, 1.0 / 200.0);
}

/// Numbers of simulated studies.
struct Coverage {
  int fitted = 0;     ///< those whose answers determine a function
  int threshold = 0;  ///< the 90 % interval holds the true threshold
  int slope = 0;
  int rejected = 0;  ///< by the deviance, with p < 0.1

  double share(int count) const { return 1.0 * count / fitted; }
};

Coverage coverage_of(const PsychometricModel& model, int trials, int studies, int resamples) {
  Coverage found;
  const double threshold = level_at(true_observer, 0.75);
  const double slope = slope_at(true_observer, threshold);
  const auto holds = [](const IntervalEnds& ends, double value) {
    return !(value < ends.low) && !(value > ends.high);  // an unknown end excludes nothing
  };
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(studies); ++i) {
    const auto counts = answers_of(true_observer, six_levels, trials, 1000 + i);
    const PsychometricFit fit = psychometric_fit(counts, model);
    if (fit.problem != FitProblem::none) continue;
    const auto intervals = psychometric_bootstrap(fit, counts, model, {0.75, 0.9, resamples}, i);
    ++found.fitted;
    found.threshold += holds(intervals.threshold, threshold) ? 1 : 0;
    found.slope += holds(intervals.slope, slope) ? 1 : 0;
    found.rejected += intervals.deviance_p < 0.1 ? 1 : 0;
  }
  testing::Test::RecordProperty(
      "threshold, slope, rejected of " + std::to_string(trials) + " trials a level",
      std::to_string(found.threshold) + " " + std::to_string(found.slope) + " " +
          std::to_string(found.rejected) + " of " + std::to_string(found.fitted));
  return found;
}

void expect_stated_coverage(int trials, int studies, int resamples) {
  const Coverage found = coverage_of({}, trials, studies, resamples);
  EXPECT_GE(found.fitted, 0.95 * studies) << trials;
  EXPECT_GE(found.share(found.threshold), 0.85) << trials;
  EXPECT_LE(found.share(found.threshold), 0.95) << trials;
  EXPECT_GE(found.share(found.slope), 0.80) << trials;
  EXPECT_LE(found.share(found.slope), 0.97) << trials;
  EXPECT_GE(found.share(found.rejected), 0.05) << trials;
  EXPECT_LE(found.share(found.rejected), 0.16) << trials;
}

TEST(PsychometricIntervals, HoldTheThresholdAsOftenAsStated) {
  expect_stated_coverage(40, 100, 99);
}

TEST(PsychometricIntervals, HoldTheThresholdAsOftenAsStatedIn400Studies) {
  for (const int trials : {25, 100}) expect_stated_coverage(trials, 400, 299);
}

}  // namespace
}  // namespace mien::pipeline
