#include "render/math/filter.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

/// Harris 1978, four terms, on −½ … ½.
double window(double x) {
  const double a = 2.0 * std::numbers::pi * x;
  return 0.35875 + 0.48829 * std::cos(a) + 0.14128 * std::cos(2.0 * a) +
         0.01168 * std::cos(3.0 * a);
}

/// Share of the window's area left of x, by the midpoint rule.
double share_left_of(double x) {
  constexpr int n = 4000;
  double left = 0.0, all = 0.0;
  for (int i = 0; i < n; ++i) {
    const double part = (i + 0.5) / n;
    left += (x + 0.5) * window(part * (x + 0.5) - 0.5);
    all += window(part - 0.5);
  }
  return left / all;
}

TEST(PixelFilter, PlacesSamplesWithTheDensityOfItsWindow) {
  const Filter filter(2.0f);
  for (int i = 1; i < 1000; ++i) {
    const float share = static_cast<float>(i) / 1000.0f;
    const auto place = static_cast<double>(filter.offset(share));
    EXPECT_NEAR(share_left_of(place / 2.0), share, 1e-4);
  }
}

TEST(PixelFilter, ReachesHalfItsWidthEachWay) {
  const Filter filter(3.0f);
  EXPECT_EQ(filter.half_width(), 1.5f);
  EXPECT_EQ(filter.offset(0.0f), -1.5f);
  EXPECT_LE(filter.offset(0x1.fffffep-1f), 1.5f);
  EXPECT_NEAR(filter.offset(0.5f), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace mien::render
