#include "pipeline/base/adaptive/quest_plus.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/adaptive/published_quest.h"

namespace mien::pipeline {
namespace {

std::vector<double> numbers(double from, double to, double by) {
  std::vector<double> result;
  for (int i = 0; from + i * by <= to + 1e-9; ++i) result.push_back(from + i * by);
  return result;
}

/// β of a Weibull function of decibels with Watson's slope.
double width_of(double slope) { return 20.0 / (slope * std::log(10.0)); }

double uniform_from(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// QUEST+ as its definition says, with no tables: products of probabilities over all answers, and
/// the entropy of each posterior that may follow.
struct Naive {
  std::vector<double> thresholds, slopes, guesses, lapses, stimuli;
  std::vector<double> threshold_prior;

  static double correct(double x, double threshold, double slope, double guess, double lapse) {
    return 1.0 - lapse -
           (1.0 - guess - lapse) * std::exp(-std::pow(10.0, slope * (x - threshold) / 20.0));
  }

  std::vector<double> posterior(const std::vector<QuestAnswer>& answers) const {
    std::vector<double> products;
    for (std::size_t i = 0; i < thresholds.size(); ++i)
      for (const double slope : slopes)
        for (const double guess : guesses)
          for (const double lapse : lapses) {
            double product = threshold_prior[i];
            for (const QuestAnswer& answer : answers) {
              const double p =
                  correct(stimuli[answer.stimulus], thresholds[i], slope, guess, lapse);
              product *= answer.outcome == 1 ? p : 1.0 - p;
            }
            products.push_back(product);
          }
    const double sum = std::accumulate(products.begin(), products.end(), 0.0);
    for (double& product : products) product /= sum;
    return products;
  }

  double expected_entropy(std::vector<QuestAnswer> answers, std::size_t stimulus) const {
    const std::vector<double> now = posterior(answers);
    double expected = 0.0;
    for (const int outcome : {0, 1}) {
      double probability = 0.0;
      std::size_t n = 0;
      for (const double threshold : thresholds)
        for (const double slope : slopes)
          for (const double guess : guesses)
            for (const double lapse : lapses) {
              const double p = correct(stimuli[stimulus], threshold, slope, guess, lapse);
              probability += now[n++] * (outcome == 1 ? p : 1.0 - p);
            }
      answers.push_back({stimulus, outcome});
      double entropy = 0.0;
      for (const double p : posterior(answers)) entropy -= p > 0.0 ? p * std::log(p) : 0.0;
      answers.pop_back();
      expected += probability * entropy;
    }
    return expected;
  }

  QuestPlus quest() const {
    std::vector<double> widths;
    for (const double slope : slopes) widths.push_back(width_of(slope));
    return psychometric_quest(Sigmoid::weibull, stimuli, {thresholds, threshold_prior}, {widths},
                              {guesses}, {lapses});
  }
};

/// Four parameters, and a prior that prefers the middle.
Naive four_parameters() {
  Naive naive{numbers(-30, -10, 2), {2.0, 3.5, 5.0},    {0.3, 0.5},
              {0.01, 0.05},         numbers(-40, 0, 4), {}};
  for (const double threshold : naive.thresholds)
    naive.threshold_prior.push_back(std::exp(-0.5 * std::pow((threshold + 18.0) / 6.0, 2.0)));
  return naive;
}

TEST(QuestPlus, HasThePosteriorAndTheChoicesOfItsDefinition) {
  const Naive naive = four_parameters();
  const QuestPlus quest = naive.quest();
  std::mt19937_64 random(5);
  std::vector<QuestAnswer> answers;
  Eigen::VectorXd posterior = quest.prior;
  for (int trial = 0; trial < 24; ++trial) {
    const std::vector<double> expected = naive.posterior(answers);
    ASSERT_EQ(posterior.size(), std::ssize(expected));
    for (Eigen::Index i = 0; i < posterior.size(); ++i)
      EXPECT_NEAR(posterior[i], expected[static_cast<std::size_t>(i)], 1e-12);
    EXPECT_EQ(posterior, posterior_after(quest, answers));
    const Eigen::VectorXd entropies = expected_entropies(quest, posterior);
    std::vector<double> all;
    for (std::size_t i = 0; i < naive.stimuli.size(); ++i)
      all.push_back(naive.expected_entropy(answers, i));
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_NEAR(entropies[static_cast<Eigen::Index>(i)], all[i], 1e-12);
    const std::size_t chosen = next_stimulus(quest, posterior);
    EXPECT_EQ(chosen, static_cast<std::size_t>(std::ranges::min_element(all) - all.begin()));
    const double p = Naive::correct(naive.stimuli[chosen], -22.0, 3.5, 0.5, 0.01);
    answers.push_back({chosen, uniform_from(random) < p ? 1 : 0});
    posterior = updated(quest, posterior, answers.back());
  }
}

TEST(QuestPlus, ChoosesTheFirstOfEqualStimuli) {
  // The same stimulus three times, and stimuli about which all points of the grid agree.
  const QuestPlus quest = psychometric_quest(Sigmoid::logistic, {-1e6, 0.0, 0.0, 0.0, 1e6},
                                             {{-1.0, 1.0}}, {{1.0}}, {{0.0}}, {{0.0}});
  EXPECT_EQ(next_stimulus(quest, quest.prior), 1u);
  // ±1 are mirror images.
  const QuestPlus mirrored = psychometric_quest(Sigmoid::logistic, {1.0, -1.0}, {{-2.0, 0.0, 2.0}},
                                                {{0.7}}, {{0.0}}, {{0.0}});
  EXPECT_EQ(next_stimulus(mirrored, mirrored.prior), 0u);
}

TEST(QuestPlus, HasAnyNumberOfOutcomes) {
  // "Less", "equal" and "more" than a standard of unknown size: two stimuli tell nothing about it.
  const auto probability = [](int outcome, double stimulus, const std::vector<double>& parameters) {
    const double distance = stimulus - parameters[0];
    const double more = 1.0 / (1.0 + std::exp(1.0 - distance));
    const double less = 1.0 / (1.0 + std::exp(1.0 + distance));
    return outcome == 0 ? less : outcome == 2 ? more : 1.0 - less - more;
  };
  const QuestPlus quest = quest_plus({-9.0, 0.5, 9.0}, {{{0.0, 1.0}, {1.0, 3.0}}}, 3, probability);
  EXPECT_DOUBLE_EQ(quest.prior[1], 0.75);
  const Eigen::VectorXd posterior = posterior_after(quest, {{1, 1}, {1, 2}});
  const double first = 0.25 * probability(1, 0.5, {0.0}) * probability(2, 0.5, {0.0});
  const double second = 0.75 * probability(1, 0.5, {1.0}) * probability(2, 0.5, {1.0});
  EXPECT_NEAR(posterior[0], first / (first + second), 1e-15);
  EXPECT_EQ(next_stimulus(quest, posterior), 1u);
  double expected = 0.0;
  for (int outcome = 0; outcome < 3; ++outcome) {
    const double a = 0.25 * probability(outcome, 0.5, {0.0});
    const double b = 0.75 * probability(outcome, 0.5, {1.0});
    expected -= a * std::log(a / (a + b)) + b * std::log(b / (a + b));
  }
  EXPECT_NEAR(expected_entropies(quest, quest.prior)[1], expected, 1e-14);
}

TEST(QuestPlus, EstimatesFromTheMarginalDistribution) {
  const QuestPlus quest = quest_plus({0.0}, {{{1.0, 2.0, 4.0}}, {{10.0, 20.0}}}, 2,
                                     [](int, double, const std::vector<double>&) { return 0.5; });
  Eigen::VectorXd posterior(6);
  posterior << 0.05, 0.05, 0.3, 0.2, 0.1, 0.3;
  const QuestEstimate first = quest_estimate(quest, posterior, 0, 0.9);
  EXPECT_NEAR(first.mean, 0.1 * 1 + 0.5 * 2 + 0.4 * 4, 1e-14);
  EXPECT_NEAR(first.deviation, std::sqrt(0.1 * 2.89 + 0.5 * 0.49 + 0.4 * 1.69), 1e-14);
  EXPECT_EQ(first.mode, 2.0);
  EXPECT_EQ(first.low, 1.0);  // up to 1: 0.1 ≥ 0.05
  EXPECT_EQ(first.high, 4.0);
  EXPECT_EQ(quest_estimate(quest, posterior, 0, 0.7).low, 2.0);  // 0.1 < 0.15
  EXPECT_EQ(quest_estimate(quest, posterior, 0, 0.1).high, 2.0);
  const QuestEstimate second = quest_estimate(quest, posterior, 1);
  EXPECT_NEAR(second.mean, 0.45 * 10 + 0.55 * 20, 1e-14);
  EXPECT_EQ(second.mode, 20.0);
}

TEST(QuestPlus, StopsByTrialsOrDeviation) {
  const QuestPlus quest =
      psychometric_quest(Sigmoid::logistic, {0.0}, {{-1.0, 1.0}}, {{1.0}}, {{0.0}}, {{0.0}});
  EXPECT_FALSE(is_finished(quest, quest.prior, 1000, {}));
  EXPECT_FALSE(is_finished(quest, quest.prior, 31, {.most_trials = 32}));
  EXPECT_TRUE(is_finished(quest, quest.prior, 32, {.most_trials = 32}));
  EXPECT_TRUE(is_finished(quest, quest.prior, 0, {.deviation = 1.0}));  // ±1 has deviation 1
  EXPECT_FALSE(is_finished(quest, quest.prior, 0, {.deviation = 0.99}));
  EXPECT_TRUE(is_finished(quest, quest.prior, 0, {.axis = 1, .deviation = 0.01}));
  EXPECT_FALSE(is_finished(quest, quest.prior, 0, {.axis = 1}));  // a fixed one has deviation 0
}

TEST(QuestPlus, RefusesAnImpossibleAnswer) {
  const QuestPlus quest = quest_plus(
      {0.0}, {{{1.0, 2.0}}}, 2,
      [](int outcome, double, const std::vector<double>&) { return outcome == 0 ? 1.0 : 0.0; });
  EXPECT_NO_THROW(posterior_after(quest, {{0, 0}}));
  EXPECT_THROW(posterior_after(quest, {{0, 1}}), Error);
}

/// Watson's (2017) axes: levels and thresholds −40 … 0 dB, guess rate 0.5.
QuestPlus published_quest(const std::vector<double>& slopes, const std::vector<double>& lapses) {
  std::vector<double> widths;
  for (const double slope : slopes) widths.push_back(width_of(slope));
  return psychometric_quest(Sigmoid::weibull, numbers(-40, 0, 1), {numbers(-40, 0, 1)}, {widths},
                            {{0.5}}, {lapses});
}

/// The posterior distribution after a published run, each level of which must be chosen again.
/// Levels so easy that they give the same information to within 1e-12 may be exchanged in so many
/// trials.
Eigen::VectorXd repeated(const QuestPlus& quest, const test::PublishedQuest& run, int exchanged) {
  Eigen::VectorXd posterior = quest.prior;
  EXPECT_EQ(run.levels.size(), run.answers.size());
  for (std::size_t i = 0; i < run.levels.size(); ++i) {
    const auto published = static_cast<std::size_t>(
        std::ranges::find(quest.stimuli, run.levels[i]) - quest.stimuli.begin());
    const std::size_t chosen = next_stimulus(quest, posterior);
    if (chosen != published) {
      --exchanged;
      const Eigen::VectorXd entropies = expected_entropies(quest, posterior);
      EXPECT_NEAR(entropies[static_cast<Eigen::Index>(chosen)],
                  entropies[static_cast<Eigen::Index>(published)], 1e-12)
          << "trial " << i << ": " << quest.stimuli[chosen];
    }
    posterior = updated(quest, posterior, {published, run.answers[i] == '+' ? 1 : 0});
  }
  EXPECT_EQ(exchanged, 0);
  return posterior;
}

TEST(PublishedQuest, ChoosesTheLevelsOfWatsonsFirstExample) {
  const QuestPlus quest = published_quest({3.5}, {0.02});
  const Eigen::VectorXd posterior = repeated(quest, test::threshold_run, 0);
  EXPECT_EQ(quest_estimate(quest, posterior, 0).mode, -20.0);
  EXPECT_NEAR(quest_estimate(quest, posterior, 0).mean, -20.39360311638961, 1e-12);
}

TEST(PublishedQuest, ChoosesTheLevelsOfWatsonsImplementation) {
  const QuestPlus quest = published_quest({2, 3, 4, 5}, {0.02});
  const Eigen::VectorXd posterior = repeated(quest, test::slope_run, 0);
  EXPECT_EQ(most_probable(quest, posterior),
            (std::vector<double>{-20.0, width_of(3.0), 0.5, 0.02}));
}

TEST(PublishedQuest, ChoosesTheLevelsOfWatsonsSecondExample) {
  const QuestPlus quest = published_quest({2, 3, 4, 5}, {0.0, 0.01, 0.02, 0.03, 0.04});
  const Eigen::VectorXd posterior = repeated(quest, test::lapse_run, 2);
  EXPECT_EQ(most_probable(quest, posterior),
            (std::vector<double>{-20.0, width_of(5.0), 0.5, 0.04}));
}

constexpr double true_threshold = -20.0;

int simulated_outcome(double stimulus, std::mt19937_64& random) {
  return uniform_from(random) < Naive::correct(stimulus, true_threshold, 3.5, 0.5, 0.02) ? 1 : 0;
}

TEST(SimulatedQuest, FindsTheThresholdWithoutBias) {
  const QuestPlus quest = published_quest({3.5}, {0.02});
  std::mt19937_64 random(17);
  constexpr int runs = 500;
  double sum = 0.0;
  double squares = 0.0;
  double deviations = 0.0;
  int held = 0;
  for (int run = 0; run < runs; ++run) {
    Eigen::VectorXd posterior = quest.prior;
    for (int trial = 0; trial < 32; ++trial) {
      const std::size_t stimulus = next_stimulus(quest, posterior);
      posterior =
          updated(quest, posterior, {stimulus, simulated_outcome(quest.stimuli[stimulus], random)});
    }
    const QuestEstimate found = quest_estimate(quest, posterior, 0, 0.95);
    sum += found.mean;
    squares += found.mean * found.mean;
    deviations += found.deviation;
    held += found.low <= true_threshold && true_threshold <= found.high ? 1 : 0;
  }
  const double mean = sum / runs;
  const double spread = std::sqrt(squares / runs - mean * mean);
  RecordProperty("mean, spread, mean deviation, held",
                 std::to_string(mean) + " " + std::to_string(spread) + " " +
                     std::to_string(deviations / runs) + " " + std::to_string(held));
  EXPECT_NEAR(mean, true_threshold, 3.0 * spread / std::sqrt(runs));
  // The posterior deviation is that of the estimates.
  EXPECT_NEAR(deviations / runs, spread, 0.2 * spread);
  EXPECT_GE(held, 0.92 * runs);
}

/// The mean number of trials until the posterior deviation of the threshold is 1 dB.
double trials_needed(const QuestPlus& quest, bool is_random) {
  std::mt19937_64 random(23);
  constexpr int runs = 100;
  constexpr int most = 400;
  double trials = 0.0;
  for (int run = 0; run < runs; ++run) {
    Eigen::VectorXd posterior = quest.prior;
    for (int trial = 0; !is_finished(quest, posterior, trial, {most, 0, 1.0}); ++trial) {
      const std::size_t stimulus =
          is_random ? random() % quest.stimuli.size() : next_stimulus(quest, posterior);
      posterior =
          updated(quest, posterior, {stimulus, simulated_outcome(quest.stimuli[stimulus], random)});
      trials += 1.0 / runs;
    }
  }
  return trials;
}

TEST(SimulatedQuest, NeedsFewerTrialsThanRandomStimuli) {
  const QuestPlus quest = published_quest({3.5}, {0.02});
  const double chosen = trials_needed(quest, false);
  const double drawn = trials_needed(quest, true);
  RecordProperty("trials chosen and drawn", std::to_string(chosen) + " " + std::to_string(drawn));
  EXPECT_LT(chosen, 0.5 * drawn);
  EXPECT_LT(drawn, 400.0);
}

}  // namespace
}  // namespace mien::pipeline
