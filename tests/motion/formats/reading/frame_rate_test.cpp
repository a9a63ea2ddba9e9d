#include "motion/formats/reading/frame_rate.h"

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

using mien::motion::frame_rate_of_period;
using mien::motion::snapped_frame_rate;

TEST(FrameRate, IsTheWholeNumberThatAFrameTimeWasRoundedFrom) {
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.0083333), 120.0);
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.00833), 120.0);
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.033333), 30.0);
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.0333), 30.0);
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.0166667), 60.0);
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.01), 100.0);
}

TEST(FrameRate, IsTheTelevisionRateWhenThatIsNearer) {
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.0333667), 30000.0 / 1001.0);
  EXPECT_EQ(snapped_frame_rate(29.97), 30000.0 / 1001.0);
  EXPECT_EQ(snapped_frame_rate(23.976), 24000.0 / 1001.0);
  EXPECT_EQ(snapped_frame_rate(1.0 / 0.0166833), 60000.0 / 1001.0);
}

TEST(FrameRate, IsTheCommonOneWhosePeriodRoundsToTheDigitsWritten) {
  const auto rate_of = [](const char* written) {
    return frame_rate_of_period(std::stod(written), written);
  };
  EXPECT_EQ(rate_of("0.0083"), 120.0);
  EXPECT_EQ(rate_of("0.033"), 30.0);
  EXPECT_EQ(rate_of(".0417"), 24.0);
  EXPECT_EQ(rate_of("0.0167"), 60.0);
  EXPECT_EQ(rate_of("0.03"), 30.0);
  EXPECT_EQ(rate_of("0.017"), 60.0);
  // Digits that tell more are heeded.
  EXPECT_EQ(rate_of("0.0333667"), 30000.0 / 1001.0);
  EXPECT_EQ(rate_of("0.041708"), 24000.0 / 1001.0);
  EXPECT_EQ(rate_of("0.008"), 125.0);
  EXPECT_EQ(rate_of("0.016"), 62.5);
  EXPECT_EQ(rate_of("0.08"), 12.5);
  EXPECT_EQ(rate_of("3.3e-2"), 1.0 / 3.3e-2);
  EXPECT_EQ(rate_of("1"), 1.0);
  // Every common rate comes back from four significant digits of its period.
  for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 90.0, 100.0, 120.0, 240.0}) {
    char written[32];
    std::snprintf(written, sizeof written, "%.*f", rate < 100.0 ? 5 : 6, 1.0 / rate);
    EXPECT_EQ(rate_of(written), rate) << written;
  }
}

TEST(FrameRate, StaysItselfWhenNothingIsNear) {
  EXPECT_EQ(snapped_frame_rate(12.5), 12.5);
  EXPECT_EQ(snapped_frame_rate(0.3), 0.3);
  EXPECT_EQ(snapped_frame_rate(59.85), 59.85);
}
