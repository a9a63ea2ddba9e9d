#include "pipeline/base/adaptive/chain_convergence.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {
namespace {

TEST(ScaleReduction, IsThatComputedByHand) {
  // Means 2 and 4, variances 1 and 4: W = 2.5, B/n = 2, so that R̂² = (2/3·2.5 + 2)/2.5.
  EXPECT_DOUBLE_EQ(scale_reduction({{1, 2, 3}, {2, 4, 6}}),
                   std::sqrt((2.0 / 3.0 * 2.5 + 2.0) / 2.5));
  // Equal means: √(3/4).
  EXPECT_DOUBLE_EQ(scale_reduction({{1, 2, 3, 2}, {3, 1, 2, 2}, {2, 2, 1, 3}}), std::sqrt(0.75));
}

TEST(ScaleReduction, NeedsTwoChainsAndValues) {
  EXPECT_TRUE(std::isnan(scale_reduction({})));
  EXPECT_TRUE(std::isnan(scale_reduction({{1, 2, 3}})));
  EXPECT_TRUE(std::isnan(scale_reduction({{1}, {2}})));
  EXPECT_TRUE(std::isnan(scale_reduction({{1, 1}, {1, 1}})));
  EXPECT_TRUE(std::isinf(scale_reduction({{1, 1}, {2, 2}})));
}

/// Chains x' = ρ x + √(1 − ρ²) ε, with standard normal values around a level of each chain.
ChainValues correlated_chains(std::size_t chains, std::size_t length, double correlation,
                              double apart) {
  ChainValues result(chains);
  for (std::size_t chain = 0; chain < chains; ++chain) {
    const std::uint64_t stream = 1000 + chain;
    double x = normal_number(stream, 0);
    for (std::size_t i = 0; i < length; ++i) {
      result[chain].push_back(x + apart * static_cast<double>(chain));
      x = correlation * x +
          std::sqrt(1.0 - correlation * correlation) * normal_number(stream, i + 1);
    }
  }
  return result;
}

TEST(ScaleReduction, IsNearOneForMixedChainsAndLargeForOnesApart) {
  EXPECT_NEAR(scale_reduction(correlated_chains(5, 200, 0.0, 0.0)), 1.0, 0.01);
  EXPECT_LT(scale_reduction(correlated_chains(5, 40, 0.3, 0.0)), 1.1);
  EXPECT_GT(scale_reduction(correlated_chains(5, 200, 0.0, 0.5)), 1.1);
  EXPECT_GT(scale_reduction(correlated_chains(5, 200, 0.0, 5.0)), 5.0);
}

/// Points after each of two steps of a sweep, with one chain's values in both dimensions.
std::vector<std::vector<std::vector<double>>> paths_of(const ChainValues& chains) {
  std::vector<std::vector<std::vector<double>>> paths;
  for (const std::vector<double>& chain : chains) {
    auto& path = paths.emplace_back();
    for (const double value : chain) {
      path.push_back({value, 7.0});  // in the middle of a sweep
      path.push_back({0.5, value});
    }
  }
  return paths;
}

TEST(ChainsThatAgree, AreThoseWhoseSecondHalvesDo) {
  // First halves far from each other, second halves equal in mean.
  ChainValues chains = {{9, 9, 9, 1, 2, 3}, {0, 0, 0, 2, 1, 3}};
  EXPECT_TRUE(have_converged(paths_of(chains), 2, 1.1));
  for (std::size_t i = 3; i < 6; ++i) chains[1][i] += 4;
  EXPECT_FALSE(have_converged(paths_of(chains), 2, 1.1));
  // In every dimension.
  auto paths = paths_of({{1, 2, 3, 1, 2, 3}, {3, 2, 1, 3, 2, 1}});
  EXPECT_TRUE(have_converged(paths, 2, 1.1));
  for (auto& point : paths[1]) point[0] += 0.1;  // constants that differ
  EXPECT_FALSE(have_converged(paths, 2, 1.1));
  // An incomplete sweep does not count, nor what other chains have more.
  chains = {{9, 9, 9, 1, 2, 3}, {0, 0, 0, 2, 1, 3}};
  paths = paths_of(chains);
  paths[0].push_back({50.0, 50.0});
  paths[1].push_back({-50.0, -50.0});
  paths[1].push_back({-50.0, -50.0});
  EXPECT_EQ(shortest_sweeps(paths, 2), 6u);
  EXPECT_TRUE(have_converged(paths, 2, 1.1));
  EXPECT_FALSE(have_converged(paths_of({{1, 2}, {1, 2}}), 2, 2.0));
}

TEST(EffectiveSampleSize, IsThatOfAutocorrelation) {
  EXPECT_NEAR(effective_sample_size(correlated_chains(8, 2000, 0.0, 0.0)), 16000.0, 1600.0);
  // (1 − ρ)/(1 + ρ) of all values.
  EXPECT_NEAR(effective_sample_size(correlated_chains(8, 2000, 0.5, 0.0)), 16000.0 / 3.0, 700.0);
  EXPECT_NEAR(effective_sample_size(correlated_chains(8, 2000, 0.8, 0.0)), 16000.0 / 9.0, 300.0);
  // Of values that alternate, no more than there are, and never a negative number.
  EXPECT_DOUBLE_EQ(effective_sample_size({{1, 4, 1, 4, 1, 4}, {4, 1, 4, 1, 4, 2}}), 12.0);
  EXPECT_DOUBLE_EQ(effective_sample_size({{1, 9}, {8, 2}}), 4.0);
  // Chains that are apart tell little about what they have in common.
  EXPECT_LT(effective_sample_size(correlated_chains(8, 200, 0.0, 3.0)), 20.0);
  EXPECT_TRUE(std::isnan(effective_sample_size({{1, 1}, {2, 2}})));
  EXPECT_TRUE(std::isnan(effective_sample_size({{1, 2, 3}})));
}

TEST(ChainMean, HasTheIntervalOfTheMeansOfChains) {
  // Means 1, 2 and 6: their mean 3, standard deviation √7; t(2) = 2.919986 for 90 %.
  const ChainMean found = chain_mean({{0, 2}, {1, 3}, {6, 6}}, 0.9);
  EXPECT_DOUBLE_EQ(found.mean, 3.0);
  EXPECT_NEAR(found.ends.low, 3.0 - 2.919985580 * std::sqrt(7.0 / 3.0), 1e-8);
  EXPECT_NEAR(found.ends.high, 3.0 + 2.919985580 * std::sqrt(7.0 / 3.0), 1e-8);
  EXPECT_EQ(chain_mean({{0, 2}}).mean, 1.0);
  EXPECT_TRUE(std::isnan(chain_mean({{0, 2}}).ends.low));
}

TEST(ChainValuesOfADimension, AreThoseAfterSweepsThatAreKept) {
  // Two steps in a sweep; the fourth sweep of the first chain is incomplete.
  const std::vector<std::vector<std::vector<double>>> paths = {
      {{0, 11}, {0, 21}, {0, 31}, {0, 41}, {0, 51}, {0, 61}, {0, 71}},
      {{1, 10}, {2, 20}, {3, 30}, {4, 40}, {5, 50}, {6, 60}, {7, 70}, {8, 80}}};
  EXPECT_EQ(chain_values(paths, 1, 2, 0), (ChainValues{{21, 41, 61}, {20, 40, 60}}));
  EXPECT_EQ(chain_values(paths, 0, 2, 1), (ChainValues{{0, 0}, {4, 6}}));
  EXPECT_EQ(chain_values(paths, 0, 2, 3), (ChainValues{{}, {}}));
}

TEST(ScaleReduction, TellsDifferentChainsFromFewValues) {
  // Three independent values in each of twelve chains: R̂ is often above 1.1, but not different.
  int above = 0, different = 0;
  for (std::uint64_t study = 0; study < 400; ++study) {
    ChainValues chains(12, std::vector<double>(3));
    for (std::size_t c = 0; c < 12; ++c)
      for (std::size_t i = 0; i < 3; ++i) chains[c][i] = normal(study, std::to_string(3 * c + i));
    above += scale_reduction(chains) > 1.1 ? 1 : 0;
    different += are_different(chains) ? 1 : 0;
  }
  EXPECT_GT(above, 40);
  EXPECT_LE(different, 3);
  ChainValues apart = {{0.1, 0.2, 0.1, 0.3, 0.2}, {0.8, 0.9, 0.8, 0.7, 0.9}};
  EXPECT_TRUE(are_different(apart));
  EXPECT_TRUE(are_different({{1.0, 1.0}, {2.0, 2.0}}));
  EXPECT_FALSE(are_different({{1.0, 2.0}}));
}

}  // namespace
}  // namespace mien::pipeline
