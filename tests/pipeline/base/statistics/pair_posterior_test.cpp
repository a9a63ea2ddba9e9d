#include "pipeline/base/statistics/pair_posterior.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "pipeline/base/statistics/bradley_terry.h"
#include "pipeline/base/statistics/named_random.h"
#include "pipeline/base/statistics/published_pairs.h"

namespace mien::pipeline {
namespace {

double chance(double difference) { return 1.0 / (1.0 + std::exp(-difference)); }

/// Comparisons of stimuli with these log-worths, `each` of every pair.
std::vector<PairCount> comparisons(const std::vector<double>& worths, int each,
                                   std::uint64_t seed) {
  std::vector<PairCount> counts;
  for (std::size_t i = 0; i < worths.size(); ++i)
    for (std::size_t j = i + 1; j < worths.size(); ++j) {
      PairCount count{.first = i, .second = j};
      for (int n = 0; n < each; ++n) {
        const std::string name =
            std::to_string(i) + "/" + std::to_string(j) + "/" + std::to_string(n);
        (uniform(seed, name) < chance(worths[i] - worths[j]) ? count.first_wins
                                                             : count.second_wins) += 1.0;
      }
      counts.push_back(count);
    }
  return counts;
}

TEST(PairPosterior, WithAFlatPriorIsTheMaximumLikelihoodEstimate) {
  const BradleyTerry fit = bradley_terry(test::citations, 4, OrderEffect::none);
  ASSERT_TRUE(fit.is_finite);
  const PairPosterior posterior = pair_posterior_with(test::citations, 4, 1e3);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(posterior.mean[static_cast<Eigen::Index>(i)] - posterior.mean.mean(), fit.worth[i],
                1e-5);
  double squares = 0.0;
  for (const double error : fit.error) squares += error * error;
  EXPECT_NEAR(posterior.deviation(), std::sqrt(squares / 4.0), 1e-5);
}

TEST(PairPosterior, WithoutComparisonsIsThePrior) {
  const PairPosterior prior = pair_posterior_with({}, 3, 1.5);
  EXPECT_TRUE(prior.mean.isZero());
  EXPECT_TRUE(prior.covariance.isApprox(2.25 * Eigen::Matrix3d::Identity()));
  EXPECT_NEAR(prior.deviation(), 1.5 * std::sqrt(2.0 / 3.0), 1e-12);
}

// Of two stimuli, the posterior of the difference is one-dimensional and can be integrated.
TEST(PairPosterior, OfTwoStimuliAgreesWithIntegration) {
  const PairPosterior found = pair_posterior_with(
      {{.first = 0, .second = 1, .first_wins = 30.0, .second_wins = 12.0}}, 2, 2.0);
  double mass = 0.0, mean = 0.0, square = 0.0;
  for (double d = -10.0; d <= 10.0; d += 0.001) {
    const double density =
        std::pow(chance(d), 30.0) * std::pow(chance(-d), 12.0) * std::exp(-0.5 * d * d / 8.0);
    mass += density;
    mean += density * d;
    square += density * d * d;
  }
  mean /= mass;
  const double variance = square / mass - mean * mean;
  const Eigen::MatrixXd& c = found.covariance;
  EXPECT_NEAR(found.mean[0] - found.mean[1], mean, 0.03);
  EXPECT_NEAR(c(0, 0) + c(1, 1) - 2.0 * c(0, 1), variance, 0.04 * variance);
}

TEST(PairPosterior, IsFiniteForWhatMaximumLikelihoodCannotEstimate) {
  const std::vector<PairCount> always = {{.first = 0, .second = 1, .first_wins = 9.0}};
  EXPECT_TRUE(std::isnan(bradley_terry(always, 3, OrderEffect::none).worth[0]));
  const PairPosterior found = pair_posterior(always, 3);
  EXPECT_GT(found.mean[0], 1.0);
  EXPECT_NEAR(found.mean[0], -found.mean[1], 1e-9);
  EXPECT_EQ(found.mean[2], 0.0);
  EXPECT_GT(found.covariance(2, 2), found.covariance(0, 0));
}

TEST(PairPosterior, CountsATieAsHalfAChoiceOfEachAndIgnoresOrder) {
  const PairPosterior tied = pair_posterior({{.first = 0, .second = 1, .ties = 8.0}}, 2);
  const PairPosterior split =
      pair_posterior({{.first = 1, .second = 0, .first_wins = 4.0, .second_wins = 4.0}}, 2);
  EXPECT_TRUE(tied.mean.isZero(1e-12));
  EXPECT_TRUE(tied.covariance.isApprox(split.covariance, 1e-12));
  EXPECT_NEAR(tied.log_evidence, split.log_evidence, 1e-9);
}

// Of two stimuli, so is the evidence: the probability of the answers in their order.
TEST(PairPosterior, HasTheEvidenceOfTheIntegral) {
  const std::vector<PairCount> counts = {
      {.first = 0, .second = 1, .first_wins = 14.0, .second_wins = 9.0}};
  for (const double prior : {0.3, 1.0, 3.0}) {
    const double variance = 2.0 * prior * prior;
    double sum = 0.0, mass = 0.0;
    for (double d = -30.0; d <= 30.0; d += 0.001) {
      const double density = std::exp(-0.5 * d * d / variance);
      mass += density;
      sum += density * std::pow(chance(d), 14.0) * std::pow(chance(-d), 9.0);
    }
    EXPECT_NEAR(pair_posterior_with(counts, 2, prior).log_evidence, std::log(sum / mass), 0.02);
  }
}

TEST(PairPosterior, FindsHowFarWorthsAreApart) {
  for (const double spread : {0.4, 1.0, 2.5}) {
    double log_found = 0.0;
    constexpr int worlds = 10;
    for (std::uint64_t world = 1; world <= worlds; ++world) {
      std::vector<double> worths;
      for (int i = 0; i < 15; ++i)
        worths.push_back(spread * normal(world, "worth/" + std::to_string(i)));
      log_found += std::log(pair_posterior(comparisons(worths, 6, world), 15).prior) / worlds;
    }
    EXPECT_NEAR(std::exp(log_found), spread, 0.25 * spread);
  }
}

// In worlds from a prior, the standardised errors have the variance that the posterior states.
TEST(PairPosterior, KnowsHowFarItIsFromTheTruth) {
  double squares = 0.0;
  constexpr int worlds = 200, stimuli = 6;
  for (std::uint64_t world = 1; world <= worlds; ++world) {
    std::vector<double> worths;
    for (int i = 0; i < stimuli; ++i)
      worths.push_back(1.5 * normal(world, "worth/" + std::to_string(i)));
    const PairPosterior found = pair_posterior_with(comparisons(worths, 8, world), stimuli, 1.5);
    const double difference = found.mean[0] - found.mean[1] - worths[0] + worths[1];
    const Eigen::MatrixXd& c = found.covariance;
    squares += difference * difference / (c(0, 0) + c(1, 1) - 2.0 * c(0, 1)) / worlds;
  }
  // The standard deviation of the mean of 200 squares is 0.1.
  EXPECT_NEAR(squares, 1.0, 0.3);
}

TEST(ExpectedComparison, IsTheMeanOverWhatIsKnown) {
  PairPosterior posterior{Eigen::Vector2d(0.7, -0.2), Eigen::Matrix2d::Identity()};
  posterior.covariance(0, 1) = posterior.covariance(1, 0) = -0.25;
  double chosen = 0.0, curvature = 0.0, mass = 0.0;
  for (double d = -15.0; d <= 15.0; d += 0.001) {
    const double density = std::exp(-0.5 * (d - 0.9) * (d - 0.9) / 2.5);
    mass += density;
    chosen += density * chance(d);
    curvature += density * chance(d) * chance(-d);
  }
  const ExpectedComparison expected = expected_comparison(posterior, 0, 1);
  EXPECT_NEAR(expected.first_chosen, chosen / mass, 1e-6);
  EXPECT_NEAR(expected.curvature, curvature / mass, 1e-6);
  const ExpectedComparison turned = expected_comparison(posterior, 1, 0);
  EXPECT_NEAR(turned.first_chosen, 1.0 - expected.first_chosen, 1e-12);
  EXPECT_NEAR(turned.curvature, expected.curvature, 1e-12);
}

// The update of one pair is that of the information matrix.
TEST(ExpectedAnswers, AddInformationAboutThePairOnly) {
  PairPosterior posterior = pair_posterior(comparisons({0.5, -0.3, 1.0, 0.0}, 5, 3), 4);
  const PairPosterior before = posterior;
  const double curvature = expected_comparison(before, 1, 3).curvature;
  const double gain = expected_gain(before, 1, 3, 7.0);
  expect_answers(posterior, 1, 3, 7.0);
  const Eigen::Vector4d pair(0.0, 1.0, 0.0, -1.0);
  const Eigen::Matrix4d information =
      before.covariance.inverse() + 7.0 * curvature * pair * pair.transpose();
  EXPECT_TRUE(posterior.covariance.isApprox(information.inverse(), 1e-9));
  EXPECT_EQ(posterior.mean, before.mean);
  EXPECT_GT(gain, 0.0);
  EXPECT_NEAR(before.variance() - posterior.variance(), gain, 1e-12);
}

TEST(ExpectedGain, IsGreatestWhereWorthsAreCloseAndUnknown) {
  const auto gain = [](double difference, double deviation) {
    const PairPosterior posterior{Eigen::Vector3d(difference, 0.0, 0.0),
                                  deviation * deviation * Eigen::Matrix3d::Identity()};
    return expected_gain(posterior, 0, 1, 5.0);
  };
  EXPECT_NEAR(gain(1.0, 0.0), 0.0, 1e-12);
  for (const double deviation : {0.3, 1.0, 2.0}) {
    EXPECT_GT(gain(0.0, deviation), gain(1.0, deviation));
    EXPECT_GT(gain(1.0, deviation), gain(3.0, deviation));
    EXPECT_GT(gain(0.5, 1.5 * deviation), gain(0.5, deviation));
  }
}

}  // namespace
}  // namespace mien::pipeline
