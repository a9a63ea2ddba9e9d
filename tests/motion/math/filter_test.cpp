#include "motion/math/filter.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

std::vector<double> sine(double hz, double rate, int count) {
  std::vector<double> signal;
  for (int i = 0; i < count; ++i) signal.push_back(std::sin(2 * pi * hz * i / rate));
  return signal;
}

/// Amplitude of the middle of a sine, by its largest value there.
double middle_amplitude(const std::vector<double>& signal) {
  double largest = 0.0;
  for (size_t i = signal.size() / 4; i < 3 * signal.size() / 4; ++i) {
    largest = std::max(largest, std::abs(signal[i]));
  }
  return largest;
}

TEST(Filter, KeepsConstantsAndStraightLines) {
  std::vector<double> line;
  for (int i = 0; i < 50; ++i) line.push_back(3.0 + 0.25 * i);
  const std::vector<double> filtered = low_pass(line, 6.0, 100.0);
  // A ramp passes a zero-phase filter of unit gain unchanged, up to how long the padding is.
  for (size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(filtered[i], line[i], 1e-4);
  const std::vector<double> level(20, -2.5);
  for (const double value : low_pass(level, 6.0, 100.0)) EXPECT_NEAR(value, -2.5, 1e-12);
}

TEST(Filter, HalvesTheAmplitudeAtItsCutoff) {
  EXPECT_NEAR(middle_amplitude(low_pass(sine(6.0, 120.0, 1200), 6.0, 120.0)), 0.5, 2e-3);
  EXPECT_NEAR(middle_amplitude(low_pass(sine(1.0, 120.0, 1200), 6.0, 120.0)), 1.0, 2e-3);
}

TEST(Filter, AttenuatesAsTheBilinearButterworthDoesTwice) {
  const double rate = 100.0;
  for (const double hz : {2.0, 9.0, 15.0, 30.0}) {
    const double warped = std::tan(pi * hz / rate) / std::tan(pi * 6.0 / rate);
    const double gain = 1.0 / (1.0 + std::pow(warped, 4.0));
    EXPECT_NEAR(middle_amplitude(low_pass(sine(hz, rate, 2000), 6.0, rate)), gain, 3e-3) << hz;
  }
}

TEST(Filter, DelaysNothing) {
  const std::vector<double> signal = sine(2.0, 100.0, 400);
  const std::vector<double> filtered = low_pass(signal, 6.0, 100.0);
  // Zero crossings of the middle stay where they are.
  for (int i = 100; i < 300; i += 25) EXPECT_NEAR(filtered[i], 0.0, 1e-3) << i;
}

TEST(Filter, OfAPeriodicSignalHasNoSeam) {
  const std::vector<double> loop = sine(2.0, 100.0, 50);  // one period
  const std::vector<double> filtered = low_pass(loop, 6.0, 100.0, SignalEnds::periodic);
  const double gain = 1.0 / (1.0 + std::pow(std::tan(pi * 0.02) / std::tan(pi * 0.06), 4.0));
  for (int i = 0; i < 50; ++i) EXPECT_NEAR(filtered[i], gain * loop[i], 1e-5) << i;
}

TEST(Filter, TreatsVectorsAsTheirCoordinates) {
  const std::vector<double> x = sine(7.0, 60.0, 80);
  std::vector<Vec3> vectors;
  for (double value : x) vectors.push_back({value, 2 * value, -value});
  const std::vector<double> filtered = low_pass(x, 6.0, 60.0);
  const std::vector<Vec3> all = low_pass(vectors, 6.0, 60.0);
  for (size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR((all[i] - Vec3(filtered[i], 2 * filtered[i], -filtered[i])).norm(), 0.0, 1e-12);
  }
}

TEST(Filter, LeavesShortSignalsAndHighCutoffsAlone) {
  EXPECT_EQ(low_pass(std::vector<double>{4.0}, 6.0, 100.0), std::vector<double>{4.0});
  EXPECT_TRUE(low_pass(std::vector<double>{}, 6.0, 100.0).empty());
  const std::vector<double> pair = {1.0, 2.0};
  EXPECT_EQ(low_pass(pair, 50.0, 100.0), pair);
  EXPECT_EQ(low_pass(pair, 6.0, 100.0).size(), 2u);
}

TEST(Filter, CutsGaitAtSixHertzOrAFifthOfTheRate) {
  EXPECT_DOUBLE_EQ(gait_cutoff_hz(120.0), 6.0);
  EXPECT_DOUBLE_EQ(gait_cutoff_hz(25.0), 5.0);
}

TEST(Derivative, OfALineIsItsSlopeEverywhere) {
  std::vector<Vec3> line;
  for (int i = 0; i < 10; ++i) line.push_back(Vec3(0.1, -0.2, 0.3) * i);
  for (const Vec3& velocity : derivative(line, 50.0)) {
    EXPECT_NEAR((velocity - Vec3(5, -10, 15)).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(derivative(std::vector<Vec3>{Vec3::Ones()}, 50.0).front(), Vec3(Vec3::Zero()));
}

TEST(Derivative, OfAPeriodicSignalGoesRoundTheSeam) {
  std::vector<Vec3> circle;
  for (int i = 0; i < 40; ++i) {
    circle.push_back({std::cos(2 * pi * i / 40), std::sin(2 * pi * i / 40), 0});
  }
  for (const Vec3& velocity : derivative(circle, 40.0, SignalEnds::periodic)) {
    EXPECT_NEAR(velocity.norm(), 40 * std::sin(2 * pi / 40), 1e-12);
  }
}

}  // namespace
}  // namespace mien::motion
