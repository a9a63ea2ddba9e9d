#include "pipeline/base/adaptive/choice_chain.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/base/adaptive/chain_convergence.h"

namespace mien::pipeline {
namespace {

double drawn_from(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

TEST(Reflection, FoldsTheLineIntoTheRange) {
  EXPECT_EQ(reflected(0.3, {0.0, 1.0}), 0.3);
  EXPECT_DOUBLE_EQ(reflected(-0.3, {0.0, 1.0}), 0.3);
  EXPECT_DOUBLE_EQ(reflected(1.3, {0.0, 1.0}), 0.7);
  EXPECT_DOUBLE_EQ(reflected(2.3, {0.0, 1.0}), 0.3);
  EXPECT_DOUBLE_EQ(reflected(-1.3, {0.0, 1.0}), 0.7);
  EXPECT_DOUBLE_EQ(reflected(-5.3, {0.0, 1.0}), 0.7);
  EXPECT_DOUBLE_EQ(reflected(8.0, {2.0, 6.0}), 4.0);
  EXPECT_DOUBLE_EQ(reflected(1.0, {2.0, 6.0}), 3.0);
  EXPECT_EQ(reflected(6.0, {2.0, 6.0}), 6.0);
}

TEST(LucesRule, ChoosesInProportion) {
  EXPECT_DOUBLE_EQ(luce_probability(std::log(3.0), 0.0), 0.75);
  EXPECT_DOUBLE_EQ(luce_probability(-1.0, -1.0), 0.5);
  EXPECT_NEAR(luce_probability(1e4 + 1.0, 1e4), 1.0 / (1.0 + std::exp(-1.0)), 1e-12);
  EXPECT_EQ(luce_probability(1e4, 0.0), 1.0);
  EXPECT_EQ(luce_probability(-1e4, 0.0), 0.0);
}

TEST(LucesRule, HasDetailedBalanceWithSymmetricProposals) {
  // Exactly, on five states with proposals to the neighbours: π_i T_ij = π_j T_ji, and π T = π.
  const std::array<double, 5> weights = {1.0, 4.0, 0.5, 2.0, 3.0};
  std::array<std::array<double, 5>, 5> transition{};
  for (std::size_t i = 0; i < 5; ++i) {
    transition[i][i] = 1.0;
    for (const std::size_t k : {(i + 1) % 5, (i + 4) % 5}) {
      transition[i][k] = 0.5 * luce_probability(std::log(weights[k]), std::log(weights[i]));
      transition[i][i] -= transition[i][k];
    }
  }
  for (std::size_t k = 0; k < 5; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
      sum += weights[i] * transition[i][k];
      EXPECT_NEAR(weights[i] * transition[i][k], weights[k] * transition[k][i], 1e-15);
    }
    EXPECT_NEAR(sum, weights[k], 1e-15);
  }
}

TEST(AChoiceTrial, DependsOnItsNumbersOnly) {
  const ChoiceSettings settings{.space = {{0.0, 1.0}, {0.0, 10.0}}, .seed = 4};
  const ChoiceTrial trial = choice_trial(settings, 1, 2, {0.5, 5.0});
  EXPECT_EQ(trial.current, (std::vector<double>{0.5, 5.0}));
  EXPECT_EQ(trial.proposal, choice_trial(settings, 1, 2, {0.5, 5.0}).proposal);
  EXPECT_NE(trial.proposal, choice_trial(settings, 2, 2, {0.5, 5.0}).proposal);
  EXPECT_NE(trial.proposal, choice_trial(settings, 1, 3, {0.5, 5.0}).proposal);
  ChoiceSettings other = settings;
  other.seed = 5;
  EXPECT_NE(trial.proposal, choice_trial(other, 1, 2, {0.5, 5.0}).proposal);
}

TEST(AChoiceTrial, HasProposalsOfTheStatedSpreadOnEitherSide) {
  const ChoiceSettings settings{.space = {{0.0, 1.0}, {0.0, 10.0}}, .deviation = 0.05, .seed = 4};
  constexpr int trials = 4000;
  int first = 0;
  std::array<double, 2> squares{};
  double product = 0.0;
  for (int step = 0; step < trials; ++step) {
    const ChoiceTrial trial = choice_trial(settings, 0, step, {0.5, 5.0});
    first += trial.is_proposal_first ? 1 : 0;
    const double a = trial.proposal[0] - 0.5;
    const double b = (trial.proposal[1] - 5.0) / 10.0;
    squares[0] += a * a / trials;
    squares[1] += b * b / trials;
    product += a * b / trials;
  }
  EXPECT_NEAR(first, trials / 2, 130);
  EXPECT_NEAR(squares[0], 0.0025, 0.0002);
  EXPECT_NEAR(squares[1], 0.0025, 0.0002);
  EXPECT_NEAR(product, 0.0, 0.00016);
}

TEST(AChoiceChain, GoesWhereItsAnswersTakeIt) {
  const ChoiceSettings settings{.space = {{0.0, 1.0}}, .seed = 2};
  std::vector<bool> answers;
  std::vector<double> point = {0.5};
  for (int step = 0; step < 40; ++step) {
    const ChoiceChain chain = choice_chain(settings, 3, {0.5}, answers);
    ASSERT_EQ(chain.path.size(), answers.size());
    const ChoiceTrial trial = choice_trial(settings, 3, step, point);
    EXPECT_EQ(chain.next.current, point);
    EXPECT_EQ(chain.next.proposal, trial.proposal);
    EXPECT_EQ(chain.next.is_proposal_first, trial.is_proposal_first);
    // Every third proposal is refused.
    const bool is_accepted = step % 3 != 0;
    answers.push_back(is_accepted == trial.is_proposal_first);
    if (is_accepted) point = trial.proposal;
  }
  EXPECT_EQ(choice_chain(settings, 3, {0.5}, answers).path.back(), point);
}

/// The points of a chain that people move who choose by Luce's rule.
std::vector<std::vector<double>> choice_path(const ChoiceSettings& settings, int chain, int steps,
                                             auto&& utility, std::mt19937_64& random) {
  const std::vector<double> start = random_start(settings.space, settings.seed, chain);
  std::vector<bool> answers;
  std::vector<double> point = start;
  for (int step = 0; step < steps; ++step) {
    const ChoiceTrial trial = choice_trial(settings, chain, step, point);
    const bool is_accepted =
        drawn_from(random) < luce_probability(utility(trial.proposal), utility(trial.current));
    answers.push_back(is_accepted == trial.is_proposal_first);
    if (is_accepted) point = trial.proposal;
  }
  return choice_chain(settings, chain, start, answers).path;
}

TEST(SimulatedChoices, HaveTheDensityAsStationaryDistributionWithDetailedBalance) {
  // Four quarters of [0, 1] with the probabilities 0.4, 0.1, 0.3 and 0.2.
  const std::array<double, 4> probability = {0.4, 0.1, 0.3, 0.2};
  const auto quarter = [](double x) {
    return std::min<std::size_t>(3, static_cast<std::size_t>(4 * x));
  };
  const ChoiceSettings settings{.space = {{0.0, 1.0}}, .deviation = 0.3, .seed = 12};
  std::mt19937_64 random(3);
  const auto path = choice_path(
      settings, 0, 60000,
      [&](const std::vector<double>& point) { return std::log(probability[quarter(point[0])]); },
      random);
  std::array<double, 4> share{};
  std::array<std::array<double, 4>, 4> moves{};
  for (std::size_t i = 1; i < path.size(); ++i) {
    share[quarter(path[i][0])] += 1.0 / static_cast<double>(path.size() - 1);
    moves[quarter(path[i - 1][0])][quarter(path[i][0])] += 1.0;
  }
  // About 12000 independent points.
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(share[i], probability[i], 0.016) << i;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NEAR(moves[i][k], moves[k][i], 3.5 * std::sqrt(moves[i][k] + moves[k][i]))
          << i << " " << k;
}

TEST(SimulatedChoices, FindMeanAndCovarianceOfAKnownDensity) {
  // A normal distribution in the unit square with correlation 0.5.
  constexpr double deviation = 0.12;
  const auto utility = [](const std::vector<double>& point) {
    const double a = (point[0] - 0.4) / deviation;
    const double b = (point[1] - 0.6) / deviation;
    return -(a * a - a * b + b * b) / 1.5;
  };
  const ChoiceSettings settings{.space = ChainSpace(2), .deviation = 0.15, .seed = 8};
  std::mt19937_64 random(4);
  std::vector<std::vector<std::vector<double>>> paths;
  for (int chain = 0; chain < 8; ++chain)
    paths.push_back(choice_path(settings, chain, 4000, utility, random));
  const ChainValues x = chain_values(paths, 0, 1, 100);
  const ChainValues y = chain_values(paths, 1, 1, 100);
  EXPECT_LT(scale_reduction(x), 1.05);
  const double mean_x = chain_mean(x).mean;
  const double mean_y = chain_mean(y).mean;
  EXPECT_NEAR(mean_x, 0.4, 0.012);
  EXPECT_NEAR(mean_y, 0.6, 0.012);
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  const double share = 1.0 / (8.0 * 3900.0);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t n = 0; n < 3900; ++n) {
      xx += share * (x[i][n] - mean_x) * (x[i][n] - mean_x);
      xy += share * (x[i][n] - mean_x) * (y[i][n] - mean_y);
      yy += share * (y[i][n] - mean_y) * (y[i][n] - mean_y);
    }
  const double variance = deviation * deviation;
  EXPECT_NEAR(xx, variance, 0.12 * variance);
  EXPECT_NEAR(yy, variance, 0.12 * variance);
  EXPECT_NEAR(xy, 0.5 * variance, 0.12 * variance);
}

}  // namespace
}  // namespace mien::pipeline
