#include "motion/interpolation/time_warp.h"

#include <random>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

std::vector<double> random_keytimes(std::mt19937_64& random) {
  std::uniform_real_distribution<double> interval(0.02, 0.6);
  std::vector<double> times = {0.0};
  for (int k = 0; k < 6; ++k) times.push_back(times.back() + interval(random));
  return times;
}

class EveryShape : public testing::TestWithParam<WarpShape> {};

TEST_P(EveryShape, IsExactAtTheKeytimes) {
  std::mt19937_64 random(31);
  for (int trial = 0; trial < 300; ++trial) {
    const auto from = random_keytimes(random);
    const auto to = random_keytimes(random);
    const TimeWarp warp = make_time_warp(from, to, GetParam(), trial % 2 == 0);
    for (size_t k = 0; k < from.size(); ++k) EXPECT_NEAR(warped(warp, from[k]), to[k], 1e-12);
  }
}

TEST_P(EveryShape, NeverRunsBackwards) {
  std::mt19937_64 random(32);
  for (int trial = 0; trial < 300; ++trial) {
    const auto from = random_keytimes(random);
    const auto to = random_keytimes(random);
    const TimeWarp warp = make_time_warp(from, to, GetParam(), trial % 2 == 0);
    double before = warped(warp, 0.0);
    for (int i = 1; i <= 2000; ++i) {
      const double now = warped(warp, from.back() * i / 2000.0);
      EXPECT_GE(now, before - 1e-12);
      before = now;
    }
  }
}

TEST_P(EveryShape, EqualTimingsGiveTheSameTime) {
  std::mt19937_64 random(33);
  const auto times = random_keytimes(random);
  const TimeWarp warp = make_time_warp(times, times, GetParam(), true);
  for (int i = 0; i <= 1000; ++i) {
    const double t = times.back() * i / 1000.0;
    EXPECT_NEAR(warped(warp, t), t, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(TimeWarp, EveryShape,
                         testing::Values(WarpShape::monotone, WarpShape::linear));

TEST(TimeWarp, MonotoneHasNoSpeedJumpAtKeytimesNorAtTheSeam) {
  std::mt19937_64 random(34);
  constexpr double step = 1e-7;
  for (int trial = 0; trial < 200; ++trial) {
    const auto from = random_keytimes(random);
    const auto to = random_keytimes(random);
    const TimeWarp warp = make_time_warp(from, to, WarpShape::monotone, true);
    const auto speed_after = [&](double t) {
      return (warped(warp, t + step) - warped(warp, t)) / step;
    };
    const auto speed_before = [&](double t) {
      return (warped(warp, t) - warped(warp, t - step)) / step;
    };
    for (size_t k = 1; k + 1 < from.size(); ++k) {
      EXPECT_NEAR(speed_before(from[k]), speed_after(from[k]), 1e-3);
    }
    EXPECT_NEAR(speed_before(from.back()), speed_after(0.0), 1e-3);
  }
}

}  // namespace
}  // namespace mien::motion
