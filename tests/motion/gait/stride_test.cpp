#include "motion/gait/stride.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

using Kind = GaitEvent::Kind;

/// Left strikes at 0, 100, …; right at 50, …; toe offs `support` frames after the other's strike.
std::vector<GaitEvent> even_events(double support, int strides) {
  std::vector<GaitEvent> events;
  for (int k = 0; k < strides; ++k) {
    events.push_back({Kind::heel_strike, true, 100.0 * k, true});
    events.push_back({Kind::toe_off, false, 100.0 * k + support, true});
    events.push_back({Kind::heel_strike, false, 100.0 * k + 50, true});
    events.push_back({Kind::toe_off, true, 100.0 * k + 50 + support, true});
  }
  return events;
}

FootProgress even_progress(int frames) {
  FootProgress progress;
  for (int t = 0; t < frames; ++t) {
    const double swing = 0.4 * std::cos(2 * 3.14159265358979 * t / 100.0);
    progress.left_heel.push_back(swing);
    progress.right_heel.push_back(-swing);
  }
  progress.left_toe = progress.left_heel;
  progress.right_toe = progress.right_heel;
  return progress;
}

TEST(Strides, AreFoundBetweenStrikesOfOneFoot) {
  const std::vector<Stride> found = strides(even_events(10, 4), even_progress(400), true);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_DOUBLE_EQ(found[1].strike, 100);
  EXPECT_DOUBLE_EQ(found[1].other_toe_off, 110);
  EXPECT_NEAR(found[1].other_passes, 125, 1e-6);
  EXPECT_DOUBLE_EQ(found[1].other_strike, 150);
  EXPECT_DOUBLE_EQ(found[1].toe_off, 160);
  EXPECT_NEAR(found[1].passes, 175, 1e-6);
  EXPECT_DOUBLE_EQ(found[1].next_strike, 200);
  EXPECT_FALSE(has_flight(found[1]));
}

TEST(Strides, OfEitherFootGiveTheSameKeytimesOnAnEvenWalk) {
  const auto events = even_events(10, 4);
  const auto left = left_based_keyframes(strides(events, even_progress(400), true)[1]);
  const Stride of_right = strides(events, even_progress(400), false)[1];
  EXPECT_DOUBLE_EQ(left_strike(of_right), 200.0);
  const auto right = left_based_keyframes(of_right);
  ASSERT_TRUE(left && right);
  const std::array<double, 7> known = {0, 10, 25, 50, 60, 75, 100};
  for (size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR((*left)[k], known[k], 1e-6) << k;
    EXPECT_NEAR((*right)[k], known[k], 1e-6) << k;
  }
}

TEST(Strides, OfRunningKeepAscendingKeytimes) {
  const std::vector<Stride> found = strides(even_events(-12, 4), even_progress(400), true);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(has_flight(found[1]));
  const auto keys = left_based_keyframes(found[1]);
  ASSERT_TRUE(keys);
  EXPECT_DOUBLE_EQ((*keys)[1], 1.0);
  EXPECT_DOUBLE_EQ((*keys)[4], 51.0);
  for (size_t k = 1; k < 7; ++k) EXPECT_GE((*keys)[k] - (*keys)[k - 1], 1.0 - 1e-9);
}

TEST(Strides, WithoutAStepOfTheOtherFootAreLeftOut) {
  std::vector<GaitEvent> events = even_events(10, 4);
  std::erase_if(events, [](const GaitEvent& event) {
    return !event.left && event.kind == Kind::heel_strike && event.frame == 150.0;
  });
  EXPECT_EQ(strides(events, even_progress(400), true).size(), 2u);
}

TEST(Strides, OfALimpWithoutPassingAreKeyedHalfWay) {
  FootProgress progress = even_progress(400);
  // The left foot leads all the time: the right one only comes up to it.
  for (double& lead : progress.left_heel) lead += 1.0;
  const std::vector<Stride> found = strides(even_events(10, 4), progress, true);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0].other_passes, 25.0, 0.5);
  EXPECT_NEAR(found[0].passes, 75.0, 0.5);
}

TEST(Strides, TooShortForSevenKeytimesHaveNone) {
  const Stride stride{true, 0, 1, 2, 3, 4, 5, 6, true};
  EXPECT_FALSE(left_based_keyframes(stride));
}

}  // namespace
}  // namespace mien::motion
