#include "pipeline/base/adaptive/staircase.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/adaptive/psychometric_function.h"

namespace mien::pipeline {
namespace {

/// Answers written as "+" and "-".
std::vector<bool> answers(const std::string& signs) {
  std::vector<bool> result;
  for (const char sign : signs) result.push_back(sign == '+');
  return result;
}

using Levels = std::vector<double>;
using Trials = std::vector<std::size_t>;

TEST(AStaircase, OfOneUpAndTwoDownIsThatCountedByHand) {
  // Two positive answers in a row are a step down, each negative one is a step up: down at trials
  // 1, 3, 8, 10 and 14, up at 5, 6, 11 and 12. Reversals: 5 (up), 8 (down), 11 (up), 14 (down).
  const StaircaseSettings settings{.start = 10.0, .positive_to_fall = 2};
  const StaircaseRun run = staircase_run(settings, answers("+++++--++++--++"));
  EXPECT_EQ(run.levels, (Levels{10, 10, 9, 9, 8, 8, 9, 10, 10, 9, 9, 8, 9, 10, 10}));
  EXPECT_EQ(run.reversals, (Trials{5, 8, 11, 14}));
  EXPECT_EQ(run.next_level, 9.0);
  EXPECT_FALSE(run.is_finished);
  const StaircaseEstimate estimate = staircase_estimate(run, 0);
  EXPECT_EQ(estimate.reversals, 4);
  EXPECT_DOUBLE_EQ(estimate.level, (8 + 10 + 8 + 10) / 4.0);
  EXPECT_DOUBLE_EQ(estimate.deviation, std::sqrt(4.0 / 3.0));
}

TEST(AStaircase, OfTwoUpAndOneDownIsItsMirrorImage) {
  const StaircaseSettings settings{.start = 10.0, .positive_to_fall = 1, .negative_to_rise = 2};
  const StaircaseRun run = staircase_run(settings, answers("-----++----++--"));
  EXPECT_EQ(run.levels, (Levels{10, 10, 11, 11, 12, 12, 11, 10, 10, 11, 11, 12, 11, 10, 10}));
  EXPECT_EQ(run.reversals, (Trials{5, 8, 11, 14}));
  EXPECT_EQ(run.next_level, 11.0);
}

TEST(AStaircase, CountsAnswersOfARowAnewAfterEachStep) {
  // The third and fourth positive answers are a step, the second and third are not.
  const StaircaseSettings settings{.start = 0.0, .positive_to_fall = 2, .negative_to_rise = 2};
  EXPECT_EQ(staircase_run(settings, answers("+++")).next_level, -1.0);
  EXPECT_EQ(staircase_run(settings, answers("++++")).next_level, -2.0);
  EXPECT_EQ(staircase_run(settings, answers("+-+-+-")).next_level, 0.0);
  EXPECT_EQ(staircase_run(settings, answers("---")).next_level, 1.0);
}

TEST(AStaircase, HasStepsOfTwoSizesAndLargerOnesAtFirst) {
  const StaircaseSettings settings{.start = 0.0,
                                   .positive_to_fall = 1,
                                   .step_down = 1.0,
                                   .step_up = 3.0,
                                   .early_factor = 4.0,
                                   .early_reversals = 2};
  const StaircaseRun run = staircase_run(settings, answers("++-++-"));
  // The second reversal, at trial 3, ends the larger steps.
  EXPECT_EQ(run.levels, (Levels{0, -4, -8, 4, 3, 2}));
  EXPECT_EQ(run.next_level, 5.0);
  EXPECT_EQ(run.reversals, (Trials{2, 3, 5}));
}

TEST(AStaircase, StaysWithinItsBounds) {
  const StaircaseSettings settings{
      .start = 1.5, .positive_to_fall = 1, .lowest = 0.0, .highest = 2.0};
  const StaircaseRun run = staircase_run(settings, answers("+++----"));
  EXPECT_EQ(run.levels, (Levels{1.5, 0.5, 0, 0, 1, 2, 2}));
  EXPECT_EQ(run.next_level, 2.0);
  // Steps that the bounds prevent are no reversals.
  EXPECT_EQ(run.reversals, (Trials{3}));
  EXPECT_EQ(staircase_run({.start = 9.0, .highest = 2.0}, {}).next_level, 2.0);
}

TEST(AStaircase, OnAGridHasItsLevelsOnly) {
  const StaircaseSettings settings{.start = 11.0,
                                   .positive_to_fall = 1,
                                   .step_down = 1.0,
                                   .step_up = 1.6,
                                   .early_factor = 0.1,
                                   .early_reversals = 1,
                                   .grid = {1, 2, 4, 8, 16, 32}};
  // Starts at 8; the first steps, of 0.1 places, are of one place.
  const StaircaseRun run = staircase_run(settings, answers("+++++--+--"));
  EXPECT_EQ(run.levels, (Levels{8, 4, 2, 1, 1, 1, 4, 16, 8, 32}));
  EXPECT_EQ(run.next_level, 32.0);
  EXPECT_EQ(staircase_run({.start = 12.0, .grid = {8, 16}}, {}).next_level, 8.0);
}

TEST(AStaircase, EndsWithReversalsOrTrials) {
  const StaircaseSettings by_reversals{.positive_to_fall = 1, .most_reversals = 2};
  EXPECT_FALSE(staircase_run(by_reversals, answers("++-")).is_finished);
  EXPECT_TRUE(staircase_run(by_reversals, answers("++-+")).is_finished);
  const StaircaseSettings by_trials{.most_reversals = 2, .most_trials = 3};
  EXPECT_FALSE(staircase_run(by_trials, answers("++")).is_finished);
  EXPECT_TRUE(staircase_run(by_trials, answers("+++")).is_finished);
}

TEST(AStaircase, EstimatesFromAnEvenNumberOfLateReversals) {
  const StaircaseSettings settings{.start = 10.0, .positive_to_fall = 1};
  const StaircaseRun run = staircase_run(settings, answers("+++--+--+"));
  ASSERT_EQ(run.reversals, (Trials{3, 5, 6, 8}));  // at 7, 9, 8, 10
  EXPECT_DOUBLE_EQ(staircase_estimate(run, 0).level, 8.5);
  EXPECT_DOUBLE_EQ(staircase_estimate(run, 1).level,
                   9.0);  // 8 and 10: of three the first is left out
  EXPECT_EQ(staircase_estimate(run, 1).reversals, 2);
  EXPECT_DOUBLE_EQ(staircase_estimate(run, 2).level, 9.0);
  for (const int left_out : {3, 4, 5}) {
    const StaircaseEstimate none = staircase_estimate(run, left_out);
    EXPECT_TRUE(none.has_too_few);
    EXPECT_TRUE(std::isnan(none.level));
    EXPECT_TRUE(std::isnan(none.deviation));
  }
  EXPECT_FALSE(staircase_estimate(run, 2).has_too_few);
}

TEST(AStaircase, HasThePublishedTarget) {
  const auto target = [](int positive, int negative, double down, double up) {
    return staircase_target({.positive_to_fall = positive,
                             .negative_to_rise = negative,
                             .step_down = down,
                             .step_up = up});
  };
  // Levitt (1971, table I).
  EXPECT_NEAR(target(1, 1, 1, 1), 0.5, 1e-12);
  EXPECT_NEAR(target(2, 1, 1, 1), 0.7071, 5e-5);
  EXPECT_NEAR(target(3, 1, 1, 1), 0.7937, 5e-5);
  EXPECT_NEAR(target(4, 1, 1, 1), 0.8409, 5e-5);
  EXPECT_NEAR(target(1, 2, 1, 1), 0.2929, 5e-5);
  // Kaernbach (1991): three times the step down for 75 %.
  EXPECT_NEAR(target(1, 1, 1, 3), 0.75, 1e-12);
  EXPECT_NEAR(target(1, 1, 2, 1), 1.0 / 3.0, 1e-12);
}

/// The mean probability of positive answers at the estimate, over simulated staircases of an
/// observer with guess rate 0, and its standard error.
struct Convergence {
  double mean = 0.0;
  double error = 0.0;
};

Convergence convergence_of(const StaircaseSettings& settings, int runs) {
  const PsychometricFunction observer{Sigmoid::logistic, 0.0, 1.0, 0.0, 0.0};
  std::mt19937_64 random(11);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < runs; ++i) {
    std::vector<bool> given;
    for (int trial = 0; trial < 500; ++trial) {
      const double level = staircase_run(settings, given).next_level;
      given.push_back(static_cast<double>(random() >> 11) * 0x1p-53 <
                      answer_probability(observer, level).positive);
    }
    const double level = staircase_estimate(staircase_run(settings, given), 60).level;
    const double p = answer_probability(observer, level).positive;
    sum += p;
    squares += p * p;
  }
  const double mean = sum / runs;
  return {mean, std::sqrt((squares / runs - mean * mean) / runs)};
}

TEST(SimulatedStaircases, ConvergeToTheirTargets) {
  struct Rule {
    int positive, negative;
    double down, up;
  };
  for (const auto& [positive, negative, down, up] :
       {Rule{1, 1, 0.06, 0.06}, Rule{2, 1, 0.06, 0.06}, Rule{3, 1, 0.06, 0.06},
        Rule{1, 2, 0.06, 0.06}, Rule{1, 1, 0.02, 0.06}, Rule{1, 1, 0.06, 0.03}}) {
    const StaircaseSettings settings{.start = 2.0,
                                     .positive_to_fall = positive,
                                     .negative_to_rise = negative,
                                     .step_down = down,
                                     .step_up = up,
                                     .early_factor = 8.0,
                                     .early_reversals = 4};
    const Convergence found = convergence_of(settings, 100);
    EXPECT_NEAR(found.mean, staircase_target(settings), 3.0 * found.error)
        << positive << " " << negative << " " << up;
    EXPECT_LT(found.error, 0.005);
  }
}

}  // namespace
}  // namespace mien::pipeline
