#include "motion/math/peaks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/geometry.h"

namespace mien::motion {
namespace {

TEST(Peaks, AreFoundBetweenSamples) {
  std::vector<double> signal;
  for (int i = 0; i < 100; ++i) signal.push_back(std::cos(2 * pi * (i - 12.3) / 40.0));
  const std::vector<Peak> peaks = prominent_peaks(signal, 0.5, 0.0);
  ASSERT_EQ(peaks.size(), 3u);
  EXPECT_NEAR(peaks[0].place, 12.3, 0.01);
  EXPECT_NEAR(peaks[1].place, 52.3, 0.01);
  EXPECT_NEAR(peaks[2].place, 92.3, 0.01);
}

TEST(Peaks, BelowTheProminenceDoNotCount) {
  const std::vector<double> signal = {0, 1, 0.9, 1.2, 0, 0.3, 0};
  const std::vector<Peak> peaks = prominent_peaks(signal, 0.5, 0.0);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_EQ(std::lround(peaks[0].place), 3);
  EXPECT_NEAR(peaks[0].prominence, 1.2, 1e-12);
}

TEST(Peaks, NearAnEndCountByTheOtherSide) {
  const std::vector<double> signal = {0.9, 1.0, 0.5, 0.0, 0.2, 0.3, 0.25};
  EXPECT_TRUE(prominent_peaks(signal, 0.5, 0.0).empty());
  const std::vector<Peak> peaks = prominent_peaks(signal, 0.5, 2.0);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_EQ(std::lround(peaks[0].place), 1);
}

TEST(Peaks, OfALevelSignalAreNone) {
  EXPECT_TRUE(prominent_peaks(std::vector<double>(9, 2.0), 0.0, 3.0).empty());
  EXPECT_TRUE(prominent_peaks(std::vector<double>{}, 0.1, 3.0).empty());
}

TEST(Peaks, OfAPlateauIsItsBeginning) {
  const std::vector<double> signal = {0, 0, 1, 1, 1, 0, 0};
  const std::vector<Peak> peaks = prominent_peaks(signal, 0.5, 0.0);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_NEAR(peaks[0].place, 2.5, 0.51);
}

}  // namespace
}  // namespace mien::motion
