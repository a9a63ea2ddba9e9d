#include "motion/formats/frame_rate.h"

#include <gtest/gtest.h>

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

TEST(FrameRate, StaysItselfWhenNothingIsNear) {
  EXPECT_EQ(snapped_frame_rate(12.5), 12.5);
  EXPECT_EQ(snapped_frame_rate(0.3), 0.3);
  EXPECT_EQ(snapped_frame_rate(59.85), 59.85);
}
