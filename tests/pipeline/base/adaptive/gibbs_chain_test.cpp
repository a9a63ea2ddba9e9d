#include "pipeline/base/adaptive/gibbs_chain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>

#include <Eigen/Core>
#include <Eigen/LU>
#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include "pipeline/base/adaptive/chain_convergence.h"
#include "pipeline/base/adaptive/chain_space.h"

namespace mien::pipeline {
namespace {

double uniform_of(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
}

TEST(RandomStart, IsUniformAndDependsOnItsNumbersOnly) {
  const ChainSpace space = {{0.0, 1.0}, {-3.0, 5.0}};
  EXPECT_EQ(random_start(space, 1, 2), random_start(space, 1, 2, 0));
  const std::set<std::vector<double>> starts = {
      random_start(space, 1, 2), random_start(space, 2, 2), random_start(space, 1, 3),
      random_start(space, 1, 2, 1)};
  EXPECT_EQ(starts.size(), 4u);
  constexpr int chains = 2000;
  std::vector<int> quarters(4);
  int together = 0;
  for (int chain = 0; chain < chains; ++chain) {
    const std::vector<double> start = random_start(space, 7, chain);
    ++quarters[static_cast<std::size_t>((start[1] + 3.0) / 2.0)];
    together += start[0] < 0.5 && start[1] < 1.0 ? 1 : 0;
  }
  // Standard error 19.
  for (const int quarter : quarters) EXPECT_NEAR(quarter, chains / 4, 60);
  EXPECT_NEAR(together, chains / 4, 60);
}

TEST(AGibbsChain, FreesEachDimensionOnceInASweepInRandomOrder) {
  const GibbsSettings settings{.dimensions = 4, .seed = 3};
  std::map<std::vector<std::size_t>, int> orders;
  for (int chain = 0; chain < 20; ++chain) {
    for (int sweep = 0; sweep < 120; ++sweep) {
      std::vector<std::size_t> order;
      for (int i = 0; i < 4; ++i) order.push_back(gibbs_dimension(settings, chain, 4 * sweep + i));
      EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 4u);
      ++orders[order];
    }
  }
  // 2400 sweeps and 24 orders: 100 each, with a standard deviation of 10.
  EXPECT_EQ(orders.size(), 24u);
  for (const auto& [order, count] : orders) EXPECT_NEAR(count, 100, 40);
  EXPECT_NE(gibbs_dimension({.dimensions = 100, .seed = 1}, 0, 0),
            gibbs_dimension({.dimensions = 100, .seed = 2}, 0, 0));
}

TEST(AGibbsSlider, StartsAnywhereInEitherDirection) {
  const GibbsSettings settings{.seed = 3};
  int reversed = 0;
  double sum = 0.0;
  double squares = 0.0;
  int together = 0;
  constexpr int sliders = 2000;
  for (int i = 0; i < sliders; ++i) {
    const auto [start, is_reversed] = gibbs_slider(settings, i % 5, i / 50, i % 50 / 5);
    reversed += is_reversed ? 1 : 0;
    sum += start / sliders;
    squares += start * start / sliders;
    together += is_reversed && start < 0.5 ? 1 : 0;
  }
  EXPECT_NEAR(reversed, sliders / 2, 90);
  EXPECT_NEAR(sum, 0.5, 0.026);
  EXPECT_NEAR(squares, 1.0 / 3.0, 0.026);
  EXPECT_NEAR(together, sliders / 4, 80);
  const double start = gibbs_slider(settings, 1, 2, 3).start;
  EXPECT_EQ(start, gibbs_slider(settings, 1, 2, 3).start);
  EXPECT_NE(start, gibbs_slider(settings, 2, 2, 3).start);
  EXPECT_NE(start, gibbs_slider(settings, 1, 3, 3).start);
  EXPECT_NE(start, gibbs_slider(settings, 1, 2, 4).start);
}

TEST(AggregatedAnswers, AreTheirMedianOrMean) {
  EXPECT_EQ(aggregated({0.3}, SliderAggregate::median), 0.3);
  EXPECT_EQ(aggregated({0.3}, SliderAggregate::mean), 0.3);
  EXPECT_EQ(aggregated({0.9, 0.1, 0.2}, SliderAggregate::median), 0.2);
  EXPECT_DOUBLE_EQ(aggregated({0.9, 0.1, 0.2, 0.4}, SliderAggregate::median), 0.3);
  EXPECT_DOUBLE_EQ(aggregated({0.9, 0.1, 0.2}, SliderAggregate::mean), 0.4);
}

TEST(AGibbsChain, IsWhereItsAnswersTakeIt) {
  const GibbsSettings settings{.dimensions = 2, .people_per_step = 3, .seed = 1};
  const GibbsChain none = gibbs_chain(settings, 4, {0.5, 0.6}, {});
  EXPECT_EQ(none.point, (std::vector<double>{0.5, 0.6}));
  EXPECT_TRUE(none.path.empty());
  const std::vector<double> answers = {0.1, 0.9, 0.2, 0.7, 0.8, 0.75, 0.3, 0.4};
  const GibbsChain chain = gibbs_chain(settings, 4, {0.5, 0.6}, answers);
  const std::size_t first = gibbs_dimension(settings, 4, 0);
  std::vector<double> point = {0.5, 0.6};
  point[first] = 0.2;
  ASSERT_EQ(chain.path.size(), 2u);
  EXPECT_EQ(chain.path[0], point);
  point[1 - first] = 0.75;
  EXPECT_EQ(chain.path[1], point);
  EXPECT_EQ(chain.point, point);
  EXPECT_EQ(chain.person, 2);
}

/// People whose choices are samples of a normal distribution in the unit cube, given the other
/// dimensions.
class SimulatedPeople {
 public:
  SimulatedPeople() : precision_(covariance().inverse()) {}

  static Eigen::Vector3d mean() { return {0.4, 0.6, 0.5}; }

  static Eigen::Matrix3d covariance() {
    constexpr double variance = 0.12 * 0.12;
    Eigen::Matrix3d result;
    result << 1.0, 0.5, -0.3, 0.5, 1.0, 0.0, -0.3, 0.0, 1.0;
    return variance * result;
  }

  double choice(const std::vector<double>& point, std::size_t dimension,
                std::mt19937_64& random) const {
    const auto d = static_cast<Eigen::Index>(dimension);
    double shift = 0.0;
    for (Eigen::Index i = 0; i < 3; ++i)
      if (i != d) shift += precision_(d, i) * (point[static_cast<std::size_t>(i)] - mean()[i]);
    const boost::math::normal given(mean()[d] - shift / precision_(d, d),
                                    1.0 / std::sqrt(precision_(d, d)));
    const double low = cdf(given, 0.0);
    const double high = cdf(given, 1.0);
    return quantile(given, low + uniform_of(random) * (high - low));
  }

 private:
  Eigen::Matrix3d precision_;
};

using Path = std::vector<std::vector<double>>;

/// A chain that people move through so many sweeps, answer by answer.
Path gibbs_path(const GibbsSettings& settings, int chain, int sweeps, std::mt19937_64& random) {
  const SimulatedPeople people;
  const ChainSpace cube(3);
  const std::vector<double> start = random_start(cube, settings.seed, chain);
  std::vector<double> point = start;
  std::vector<double> answers;
  for (int step = 0; step < 3 * sweeps; ++step) {
    const std::size_t dimension = gibbs_dimension(settings, chain, step);
    std::vector<double> of_step;
    for (int person = 0; person < settings.people_per_step; ++person)
      of_step.push_back(people.choice(point, dimension, random));
    answers.insert(answers.end(), of_step.begin(), of_step.end());
    point[dimension] = aggregated(of_step, settings.aggregate);
  }
  return gibbs_chain(settings, chain, start, answers).path;
}

std::vector<Path> gibbs_paths(const GibbsSettings& settings, int chains, int sweeps,
                              std::mt19937_64& random) {
  std::vector<Path> paths;
  for (int chain = 0; chain < chains; ++chain)
    paths.push_back(gibbs_path(settings, chain, sweeps, random));
  return paths;
}

TEST(SimulatedGibbsSampling, FindsMeanAndCovarianceOfAKnownDensity) {
  std::mt19937_64 random(5);
  const auto paths = gibbs_paths({.dimensions = 3, .seed = 9}, 8, 500, random);
  std::vector<ChainValues> values;
  Eigen::Vector3d mean;
  for (std::size_t i = 0; i < 3; ++i) {
    values.push_back(chain_values(paths, i, 3, 2));
    mean[static_cast<Eigen::Index>(i)] = chain_mean(values.back()).mean;
    EXPECT_LT(scale_reduction(values.back()), 1.02);
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t chain = 0; chain < 8; ++chain)
    for (std::size_t n = 0; n < values[0][chain].size(); ++n) {
      const Eigen::Vector3d from_mean =
          Eigen::Vector3d(values[0][chain][n], values[1][chain][n], values[2][chain][n]) - mean;
      covariance += from_mean * from_mean.transpose() / (8.0 * 498.0);
    }
  // Of about 2000 independent points: standard errors 0.003, and 3 % of the variance.
  EXPECT_LT((mean - SimulatedPeople::mean()).cwiseAbs().maxCoeff(), 0.012);
  EXPECT_LT((covariance - SimulatedPeople::covariance()).cwiseAbs().maxCoeff(), 0.0018);
}

TEST(SimulatedGibbsSampling, FindsTheMeanInAShortStudy) {
  // 5 chains of 20 sweeps, alone and with the median of 5 people, who narrow the distribution.
  std::mt19937_64 random(6);
  for (const int people : {1, 5}) {
    const auto paths =
        gibbs_paths({.dimensions = 3, .people_per_step = people, .seed = 11}, 5, 20, random);
    for (std::size_t i = 0; i < 3; ++i) {
      const ChainValues values = chain_values(paths, i, 3, 2);
      EXPECT_NEAR(chain_mean(values).mean, SimulatedPeople::mean()[static_cast<Eigen::Index>(i)],
                  0.05);
      double squares = 0.0;
      for (const auto& chain : values)
        for (const double value : chain)
          squares += std::pow(value - chain_mean(values).mean, 2.0) / (5.0 * 18.0);
      if (people == 5) {
        EXPECT_LT(std::sqrt(squares), 0.09);
      } else {
        EXPECT_GT(std::sqrt(squares), 0.09);
      }
    }
  }
}

/// The share of 90 % intervals that hold the true mean, over studies of 5 chains of 20 sweeps.
double mean_coverage_of(int studies, std::uint64_t seed) {
  int held = 0;
  for (int study = 0; study < studies; ++study) {
    const auto own_seed = seed + static_cast<std::uint64_t>(study);
    std::mt19937_64 random(own_seed);
    const auto paths = gibbs_paths({.dimensions = 3, .seed = own_seed}, 5, 20, random);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = chain_mean(chain_values(paths, i, 3, 2), 0.9).ends;
      const double truth = SimulatedPeople::mean()[static_cast<Eigen::Index>(i)];
      held += low <= truth && truth <= high ? 1 : 0;
    }
  }
  return held / (3.0 * studies);
}

TEST(IntervalsOfChains, HoldTheMeanAsOftenAsStated) {
  const double coverage = mean_coverage_of(200, 100);
  RecordProperty("coverage", std::to_string(coverage));
  EXPECT_GE(coverage, 0.85);
  EXPECT_LE(coverage, 0.95);
}

}  // namespace
}  // namespace mien::pipeline
