#include "pipeline/base/adaptive/psychometric_function.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

constexpr Sigmoid sigmoids[] = {Sigmoid::logistic, Sigmoid::normal, Sigmoid::weibull};

TEST(Sigmoids, AreThoseOfTheirFormulas) {
  EXPECT_NEAR(sigmoid_at(Sigmoid::logistic, 1.2).below, 1.0 / (1.0 + std::exp(-1.2)), 1e-15);
  EXPECT_NEAR(sigmoid_at(Sigmoid::normal, 1.959963984540054).below, 0.975, 1e-12);
  EXPECT_NEAR(sigmoid_at(Sigmoid::weibull, 0.0).below, 1.0 - std::exp(-1.0), 1e-15);
  EXPECT_NEAR(sigmoid_at(Sigmoid::weibull, 0.7).below, 1.0 - std::exp(-std::exp(0.7)), 1e-15);
}

TEST(Sigmoids, HaveTheirDerivativeComplementAndInverse) {
  for (const Sigmoid sigmoid : sigmoids) {
    for (const double z : {-3.0, -0.4, 0.0, 0.9, 1.6}) {
      const SigmoidValue value = sigmoid_at(sigmoid, z);
      const double difference =
          sigmoid_at(sigmoid, z + 1e-5).below - sigmoid_at(sigmoid, z - 1e-5).below;
      EXPECT_NEAR(value.density, difference / 2e-5, 1e-9);
      EXPECT_NEAR(value.below + value.above, 1.0, 1e-15);
      EXPECT_NEAR(sigmoid_quantile(sigmoid, value.below), z, 1e-10);
    }
  }
}

TEST(Sigmoids, KeepTheirTails) {
  EXPECT_NEAR(sigmoid_at(Sigmoid::logistic, 50.0).above / std::exp(-50.0), 1.0, 1e-12);
  EXPECT_NEAR(sigmoid_at(Sigmoid::normal, 10.0).above / 7.619853024160527e-24, 1.0, 1e-12);
  EXPECT_NEAR(sigmoid_at(Sigmoid::weibull, 4.0).above / std::exp(-std::exp(4.0)), 1.0, 1e-12);
  EXPECT_NEAR(sigmoid_at(Sigmoid::weibull, -50.0).below / std::exp(-50.0), 1.0, 1e-12);
  EXPECT_EQ(sigmoid_at(Sigmoid::weibull, 800.0).density, 0.0);
}

/// The function of Watson (2017): threshold −20 dB, slope 3.5, guess 0.5, lapse 0.02.
constexpr double watson_slope = 3.5;
const PsychometricFunction watson = {Sigmoid::weibull, -20.0,
                                     20.0 / (watson_slope * std::log(10.0)), 0.5, 0.02};

TEST(APsychometricFunction, OfDecibelsIsWatsons) {
  for (double level = -40.0; level <= 0.0; level += 2.5) {
    const double power = std::pow(10.0, watson_slope * (level + 20.0) / 20.0);
    const double expected = 1.0 - 0.02 - (1.0 - 0.5 - 0.02) * std::exp(-power);
    EXPECT_NEAR(answer_probability(watson, level).positive, expected, 1e-14);
    EXPECT_NEAR(answer_probability(watson, level).negative, 1.0 - expected, 1e-14);
  }
}

TEST(APsychometricFunction, HasItsThresholdAndSlope) {
  for (const Sigmoid sigmoid : sigmoids) {
    const PsychometricFunction function{sigmoid, 1.5, 0.4, 0.25, 0.05};
    for (const double proportion : {0.3, 0.6, 0.9}) {
      const double level = level_at(function, proportion);
      EXPECT_NEAR(answer_probability(function, level).positive, proportion, 1e-12);
      const double difference = answer_probability(function, level + 1e-5).positive -
                                answer_probability(function, level - 1e-5).positive;
      EXPECT_NEAR(slope_at(function, level), difference / 2e-5, 1e-8);
    }
    EXPECT_TRUE(std::isnan(level_at(function, 0.25)));
    EXPECT_TRUE(std::isnan(level_at(function, 0.95)));
    EXPECT_TRUE(std::isnan(level_at(function, 0.1)));
  }
}

}  // namespace
}  // namespace mien::pipeline
