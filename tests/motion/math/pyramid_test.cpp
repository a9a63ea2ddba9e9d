#include "motion/math/pyramid.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

std::vector<double> random_signal(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<double> signal(count);
  for (double& sample : signal) sample = number(generator);
  return signal;
}

std::vector<double> impulse(std::size_t count) {
  std::vector<double> signal(count, 0.0);
  signal[count / 2] = 1.0;
  return signal;
}

TEST(Pyramid, HasAsManyBandsAsTheLengthHasPowersOfTwo) {
  EXPECT_EQ(band_count(1), 0);
  EXPECT_EQ(band_count(2), 1);
  EXPECT_EQ(band_count(63), 5);
  EXPECT_EQ(band_count(64), 6);
  EXPECT_EQ(band_count(100000), 16);
}

TEST(Pyramid, SumsToTheSignal) {
  for (const std::size_t count : {1u, 2u, 7u, 33u, 100u, 257u}) {
    for (const SignalEnds ends : {SignalEnds::open, SignalEnds::periodic}) {
      const std::vector<double> signal = random_signal(count, 3);
      const auto parts = pyramid(std::span<const double>(signal), band_count(count), ends);
      for (std::size_t i = 0; i < count; ++i) {
        double sum = parts.rest[i];
        for (const auto& band : parts.bands) sum += band[i];
        EXPECT_NEAR(sum, signal[i], 1e-12);
      }
    }
  }
}

TEST(Pyramid, SmoothsAnImpulseByTheBinomialKernel) {
  const std::vector<double> signal = impulse(65);
  const auto parts = pyramid(std::span<const double>(signal), 1, SignalEnds::open);
  const double expected[] = {1, 4, 6, 4, 1};
  for (int i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(parts.rest[30 + i], expected[i] / 16.0);
}

TEST(Pyramid, SmoothsAnImpulseTwiceAsComputedByHand) {
  const std::vector<double> signal = impulse(65);
  const auto parts = pyramid(std::span<const double>(signal), 2, SignalEnds::open);
  const double expected[] = {1, 4, 10, 20, 31, 40, 44, 40, 31, 20, 10, 4, 1};
  for (int i = 0; i < 13; ++i) EXPECT_DOUBLE_EQ(parts.rest[26 + i], expected[i] / 256.0);
}

TEST(Pyramid, DampsASineOfPeriodEightAsItsResponseSays) {
  std::vector<double> signal;
  for (int i = 0; i < 64; ++i) signal.push_back(std::sin(2.0 * pi * i / 8.0));
  const auto parts = pyramid(std::span<const double>(signal), 1, SignalEnds::periodic);
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_NEAR(parts.rest[i], 0.7285533906 * signal[i], 1e-10);
  }
}

TEST(Pyramid, LetsConstantsPass) {
  const std::vector<double> signal(100, 2.5);
  for (const SignalEnds ends : {SignalEnds::open, SignalEnds::periodic}) {
    const auto parts = pyramid(std::span<const double>(signal), 6, ends);
    for (const auto& band : parts.bands) {
      for (const double sample : band) EXPECT_NEAR(sample, 0.0, 1e-15);
    }
    EXPECT_NEAR(parts.rest[50], 2.5, 1e-15);
  }
}

TEST(Pyramid, SeesRepeatedEndsAsALongerSignalWithTheseEnds) {
  const std::vector<double> signal = random_signal(50, 5);
  std::vector<double> longer(400, signal.front());
  longer.insert(longer.end(), signal.begin(), signal.end());
  longer.insert(longer.end(), 400, signal.back());
  const auto parts = pyramid(std::span<const double>(signal), 5, SignalEnds::open);
  const auto longer_parts = pyramid(std::span<const double>(longer), 5, SignalEnds::open);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    EXPECT_NEAR(parts.rest[i], longer_parts.rest[400 + i], 1e-14);
    EXPECT_NEAR(parts.bands[4][i], longer_parts.bands[4][400 + i], 1e-14);
  }
}

TEST(Pyramid, OfAPeriodicSignalDoesNotMindWhereItBegins) {
  const std::vector<double> signal = random_signal(37, 6);
  std::vector<double> turned(signal.begin() + 10, signal.end());
  turned.insert(turned.end(), signal.begin(), signal.begin() + 10);
  const auto parts = pyramid(std::span<const double>(signal), 5, SignalEnds::periodic);
  const auto turned_parts = pyramid(std::span<const double>(turned), 5, SignalEnds::periodic);
  for (std::size_t i = 0; i < 27; ++i) {
    EXPECT_NEAR(turned_parts.bands[3][i], parts.bands[3][i + 10], 1e-15);
  }
}

TEST(Pyramid, WeightsItsBandsAsTheirSumWould) {
  const std::vector<double> gains = {0.3, 1.2, 1.8, 1.8, 0.7};
  for (const SignalEnds ends : {SignalEnds::open, SignalEnds::periodic}) {
    const std::vector<double> signal = random_signal(120, 8);
    const auto parts = pyramid(std::span<const double>(signal), 5, ends);
    const auto weighted = with_band_gains(std::span<const double>(signal), gains, 0.9, ends);
    for (std::size_t i = 0; i < signal.size(); ++i) {
      double sum = 0.9 * parts.rest[i];
      for (std::size_t k = 0; k < gains.size(); ++k) sum += gains[k] * parts.bands[k][i];
      EXPECT_NEAR(weighted[i], sum, 1e-12);
    }
  }
}

TEST(Pyramid, OfVectorsIsThatOfTheirNumbers) {
  const std::vector<double> signal = random_signal(64, 9);
  std::vector<Vec3> vectors;
  for (const double sample : signal) vectors.emplace_back(sample, 2.0 * sample, -sample);
  const std::vector<double> gains = {0.0, 2.0, 0.5};
  const auto numbers =
      with_band_gains(std::span<const double>(signal), gains, 1.0, SignalEnds::open);
  const auto result = with_band_gains(std::span<const Vec3>(vectors), gains, 1.0, SignalEnds::open);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    EXPECT_NEAR((result[i] - Vec3(1, 2, -1) * numbers[i]).norm(), 0.0, 1e-14);
  }
}

TEST(Pyramid, AnswersMostToThePeakOfEachBand) {
  // Amplitude of band k for a sine, from the product of its kernels.
  const auto level = [](int k, double x) {
    return std::pow(std::sin(std::exp2(k) * x) / (std::exp2(k) * std::sin(x)), 4.0);
  };
  for (int band = 1; band < 8; ++band) {
    const auto response = [&](double hz) {
      const double x = pi * hz / 100.0;
      return level(band, x) - level(band + 1, x);
    };
    const double peak = band_peak_hz(band, 100.0);
    EXPECT_GT(response(peak), response(0.99 * peak)) << band;
    EXPECT_GT(response(peak), response(1.01 * peak)) << band;
  }
  EXPECT_NEAR(band_peak_hz(2, 120.0), 8.0, 0.03);
  EXPECT_NEAR(band_peak_hz(4, 30.0), 0.495, 0.001);
}

}  // namespace
}  // namespace mien::motion
