#include "pipeline/base/adaptive/psychometric_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "motion/math/random_number.h"
#include "pipeline/base/statistics/reference_values.h"

namespace mien::pipeline {
namespace {

constexpr RateRange zero_rate = {0.0, 0.0};

/// Answers of reference/psychometric_function.R.
std::vector<LevelCount> reference_counts(const std::string& name) {
  const std::string file = "psychometric_samples.csv";
  const std::vector<double> levels = test::sample(name + "/level", file);
  const std::vector<double> trials = test::sample(name + "/trials", file);
  const std::vector<double> positive = test::sample(name + "/positive", file);
  std::vector<LevelCount> counts;
  for (std::size_t i = 0; i < levels.size(); ++i)
    counts.push_back({levels[i], static_cast<int>(trials[i]), static_cast<int>(positive[i])});
  return counts;
}

test::Expected reference_fit(const std::string& name) {
  return test::Expected(name, "psychometric_expected.csv");
}

void expect_fit(test::Expected& expected, const PsychometricFit& fit, double within) {
  EXPECT_EQ(fit.problem, FitProblem::none);
  expected.is("location", fit.function.location, within);
  expected.is("width", fit.function.width, within);
  expected.is("deviance", fit.deviance, 1e-7);
  expected.is("log_likelihood", fit.log_likelihood, 1e-7);
}

constexpr std::pair<const char*, Sigmoid> named_sigmoids[] = {
    {"logistic", Sigmoid::logistic}, {"normal", Sigmoid::normal}, {"weibull", Sigmoid::weibull}};

TEST(APsychometricFit, WithFixedRatesIsThatOfGlmAndPsyphy) {
  for (const auto& [name, sigmoid] : named_sigmoids) {
    for (const char* alternatives : {"1", "2", "4"}) {
      const std::string both = std::string(name) + "/" + alternatives;
      test::Expected expected = reference_fit(both);
      const double guess = expected.at("guess");
      expect_fit(expected,
                 psychometric_fit(reference_counts(both), {sigmoid, {guess, guess}, zero_rate}),
                 1e-6);
    }
  }
}

TEST(APsychometricFit, OfPublishedLettersIsThatOfPsyphy) {
  for (const char* task : {"DET", "ID"}) {
    for (const char* size : {"12.4", "20.6", "41.3", "83"}) {
      const std::string name = std::string("letters/") + task + "/" + size;
      test::Expected expected = reference_fit(name);
      const double guess = expected.at("guess");
      const PsychometricFit fit =
          psychometric_fit(reference_counts(name), {Sigmoid::weibull, {guess, guess}, zero_rate});
      expect_fit(expected, fit, 1e-6);
      expected.is("threshold", level_at(fit.function, 0.625), 1e-6);
    }
  }
}

TEST(APsychometricFit, WithAnEstimatedLapseRateHasTheGreatestProfile) {
  for (const char* name : {"lapse/2", "lapse/3", "no-lapse", "bounded-lapse"}) {
    test::Expected expected = reference_fit(name);
    const double guess = expected.at("guess");
    const PsychometricFit fit =
        psychometric_fit(reference_counts(name), {Sigmoid::normal, {guess, guess}, {0.0, 0.06}});
    expect_fit(expected, fit, 1e-5);
    expected.is("lapse", fit.function.lapse, 1e-6);
    EXPECT_EQ(fit.function.guess, guess);
  }
}

TEST(APsychometricFit, OfYesNoTrialsHasBothRates) {
  test::Expected expected = reference_fit("yes-no");
  const PsychometricFit fit =
      psychometric_fit(reference_counts("yes-no"), {Sigmoid::logistic, {0.0, 0.5}, {0.0, 0.06}});
  expect_fit(expected, fit, 1e-5);
  expected.is("guess", fit.function.guess, 1e-6);
  expected.is("lapse", fit.function.lapse, 1e-6);
}

const std::vector<LevelCount> rising_counts = {{0.0, 40, 21}, {1.0, 40, 22}, {2.0, 40, 27},
                                               {3.0, 40, 33}, {4.0, 40, 38}, {5.0, 40, 39}};

TEST(APsychometricFit, FollowsUnitAndOriginOfTheLevels) {
  const PsychometricModel model;
  const PsychometricFit fit = psychometric_fit(rising_counts, model);
  std::vector<LevelCount> others = rising_counts;
  for (LevelCount& count : others) count.level = 1000.0 - 0.01 * count.level;
  for (LevelCount& count : others) count.level = 500.0 - count.level;
  const PsychometricFit other = psychometric_fit(others, model);
  EXPECT_NEAR(other.function.width, 0.01 * fit.function.width, 1e-8);
  EXPECT_NEAR(other.function.location, -500.0 + 0.01 * fit.function.location, 1e-8);
  EXPECT_NEAR(other.function.lapse, fit.function.lapse, 1e-7);
  EXPECT_NEAR(other.deviance, fit.deviance, 1e-9);
}

TEST(APsychometricFit, DoesNotDependOnHowCountsAreGrouped) {
  const PsychometricFit fit = psychometric_fit(rising_counts, {});
  std::vector<LevelCount> parts;
  for (const LevelCount& count : rising_counts) {
    parts.push_back({count.level, 30, count.positive - 10});
    parts.insert(parts.begin(), {count.level, 10, 10});
    parts.push_back({count.level + 0.5, 0, 0});
  }
  const PsychometricFit other = psychometric_fit(parts, {});
  EXPECT_EQ(other.function.location, fit.function.location);
  EXPECT_EQ(other.deviance, fit.deviance);
}

TEST(APsychometricFit, IsNotBetterAnywhereNear) {
  const PsychometricModel model{Sigmoid::normal, {0.0, 0.5}, {0.0, 0.1}};
  const std::vector<LevelCount> counts = reference_counts("yes-no");
  const auto likelihood = [&](const PsychometricFunction& function) {
    double sum = 0.0;
    for (const LevelCount& count : counts) {
      const auto [positive, negative] = answer_probability(function, count.level);
      sum += count.positive * std::log(positive) +
             (count.trials - count.positive) * std::log(negative);
    }
    return sum;
  };
  const PsychometricFit fit = psychometric_fit(counts, model);
  EXPECT_NEAR(likelihood(fit.function), fit.log_likelihood, 1e-9);
  for (double PsychometricFunction::*member :
       {&PsychometricFunction::location, &PsychometricFunction::width, &PsychometricFunction::guess,
        &PsychometricFunction::lapse}) {
    for (const double change : {-1e-4, 1e-4}) {
      PsychometricFunction other = fit.function;
      other.*member += change;
      EXPECT_LT(likelihood(other), fit.log_likelihood);
    }
  }
}

FitProblem problem_of(const std::vector<LevelCount>& counts, const PsychometricModel& model = {}) {
  const PsychometricFit fit = psychometric_fit(counts, model);
  EXPECT_EQ(std::isnan(fit.function.location), fit.problem != FitProblem::none);
  EXPECT_EQ(std::isnan(fit.function.width), fit.problem != FitProblem::none);
  EXPECT_EQ(std::isnan(fit.step.low), fit.problem != FitProblem::step);
  return fit.problem;
}

TEST(APsychometricFit, SaysWhyAnswersDoNotDetermineIt) {
  EXPECT_EQ(problem_of({}), FitProblem::no_trials);
  EXPECT_EQ(psychometric_fit({}, {}).function.guess, 0.5);
  EXPECT_TRUE(std::isnan(psychometric_fit({}, {}).function.lapse));
  EXPECT_EQ(problem_of({{1.0, 0, 0}}), FitProblem::no_trials);
  EXPECT_EQ(problem_of({{0.0, 9, 0}, {1.0, 8, 0}, {2.0, 7, 0}}), FitProblem::all_negative);
  EXPECT_EQ(problem_of({{0.0, 9, 9}, {1.0, 8, 8}, {2.0, 7, 7}}), FitProblem::all_positive);
  const std::vector<LevelCount> two = {{0.0, 10, 5}, {1.0, 10, 8}};
  EXPECT_EQ(problem_of(two), FitProblem::too_few_levels);
  EXPECT_EQ(problem_of(two, {Sigmoid::logistic, zero_rate, zero_rate}), FitProblem::none);
  EXPECT_EQ(problem_of({{0.0, 10, 9}, {1.0, 10, 7}, {2.0, 10, 5}, {3.0, 10, 6}}),
            FitProblem::not_rising);
  // Below chance: rising, but a constant 0.5 is nearest.
  EXPECT_EQ(problem_of({{0.0, 20, 1}, {1.0, 20, 4}, {2.0, 20, 8}, {3.0, 20, 9}}),
            FitProblem::not_rising);
  EXPECT_EQ(problem_of({{0.0, 20, 10}, {1.0, 20, 10}, {2.0, 20, 20}, {3.0, 20, 20}}),
            FitProblem::step);
}

TEST(APsychometricFit, SaysWhereAStepLies) {
  for (const auto& [name, sigmoid] : named_sigmoids) {
    const PsychometricModel model{sigmoid, zero_rate, zero_rate};
    // Complete separation, and separation but for one level.
    const PsychometricFit between =
        psychometric_fit({{0.0, 9, 0}, {1.0, 9, 0}, {2.5, 9, 9}, {3.0, 9, 9}}, model);
    EXPECT_EQ(between.problem, FitProblem::step) << name;
    EXPECT_EQ(between.step.low, 1.0);
    EXPECT_EQ(between.step.high, 2.5);
    EXPECT_EQ(between.deviance, 0.0);
    const PsychometricFit at =
        psychometric_fit({{0.0, 9, 0}, {1.0, 9, 4}, {2.5, 9, 9}, {3.0, 9, 9}}, model);
    EXPECT_EQ(at.problem, FitProblem::step) << name;
    EXPECT_EQ(at.step.low, 1.0);
    EXPECT_EQ(at.step.high, 1.0);
    // One answer in the other order.
    EXPECT_EQ(problem_of({{0.0, 9, 0}, {1.0, 9, 1}, {2.5, 9, 8}, {3.0, 9, 9}, {4.0, 9, 9}}, model),
              FitProblem::none)
        << name;
  }
}

TEST(APsychometricFit, OfAStepOrAConstantHasTheDevianceOfThatLimit) {
  // A step at 1: chance below and no lapse above.
  const PsychometricModel model{Sigmoid::logistic, {0.5, 0.5}, zero_rate};
  const PsychometricFit step =
      psychometric_fit({{0.0, 20, 9}, {1.0, 20, 20}, {2.0, 20, 20}}, model);
  EXPECT_EQ(step.problem, FitProblem::step);
  EXPECT_NEAR(step.deviance, 2.0 * (9 * std::log(0.9) + 11 * std::log(1.1)), 1e-9);
  const PsychometricFit flat =
      psychometric_fit({{0.0, 20, 18}, {1.0, 20, 14}, {2.0, 20, 13}}, model);
  EXPECT_EQ(flat.problem, FitProblem::not_rising);
  EXPECT_NEAR(flat.log_likelihood, 45 * std::log(0.75) + 15 * std::log(0.25), 1e-9);
}

TEST(APsychometricFit, HasNoStepThatGoesDownBeforeItRises) {
  // A step at level 1, from 0.4 below it to 0.1 at it, would fit exactly.
  const PsychometricFit fit =
      psychometric_fit({{0.0, 30, 12}, {1.0, 30, 3}, {2.0, 30, 30}, {3.0, 30, 30}},
                       {Sigmoid::logistic, {0.0, 0.5}, zero_rate});
  EXPECT_EQ(fit.problem, FitProblem::step);
  EXPECT_EQ(fit.step.low, 1.0);
  EXPECT_EQ(fit.step.high, 2.0);
  EXPECT_NEAR(fit.log_likelihood, 15 * std::log(0.25) + 45 * std::log(0.75), 1e-9);
}

/// The greatest likelihood of a grid of functions.
double best_of_grid(const std::vector<LevelCount>& counts, const PsychometricModel& model) {
  double best = -1e300;
  for (int a = -8; a <= 28; ++a)
    for (int b = 0; b < 16; ++b)
      for (const double guess : {0.0, 0.2, 0.5})
        for (const double lapse : {0.0, 0.03, 0.06}) {
          const PsychometricFunction function{model.sigmoid, 0.25 * a, 0.05 * std::pow(1.4, b),
                                              guess, lapse};
          double sum = 0.0;
          for (const LevelCount& count : counts) {
            const auto [positive, negative] = answer_probability(function, count.level);
            const int wrong = count.trials - count.positive;
            sum += (count.positive > 0 ? count.positive * std::log(positive) : 0.0) +
                   (wrong > 0 ? wrong * std::log(negative) : 0.0);
          }
          best = std::max(best, sum);
        }
  return best;
}

TEST(APsychometricFit, OfAnyAnswersIsAtLeastAsGoodAsTheBestOfAGrid) {
  // Answers without any order, and those of an observer, at few trials a level.
  for (const auto& [name, sigmoid] : named_sigmoids) {
    const PsychometricModel model{sigmoid, {0.0, 0.5}, {0.0, 0.06}};
    for (std::uint64_t n = 0; n < 40; ++n) {
      std::vector<LevelCount> counts;
      for (std::uint64_t i = 0; i < 6; ++i) {
        const double level = static_cast<double>(i);
        const double p = n % 2 == 0 ? motion::open_unit_number(motion::random_bits(n, i))
                                    : sigmoid_at(sigmoid, 3.0 * (level - 2.4)).below;
        int positive = 0;
        for (std::uint64_t trial = 0; trial < 12; ++trial)
          positive +=
              motion::open_unit_number(motion::random_bits(1000 + n, 12 * i + trial)) < p ? 1 : 0;
        counts.push_back({level, 12, positive});
      }
      EXPECT_GE(psychometric_fit(counts, model).log_likelihood, best_of_grid(counts, model) - 1e-9)
          << name << " " << n;
    }
  }
}

}  // namespace
}  // namespace mien::pipeline
