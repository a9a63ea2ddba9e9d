#include "render/video/yuv.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

struct Planes {
  std::vector<std::uint8_t> y, u, v;
  Yuv420 picture;

  Planes(int width, int height)
      : y(static_cast<std::size_t>(width * height)),
        u(y.size() / 4),
        v(y.size() / 4),
        picture{width, height, {y.data(), u.data(), v.data()}, {width, width / 2, width / 2}} {}
};

TEST(Yuv, IsBt709OfLimitedRange) {
  Planes planes(4, 4);
  for (int y = 0; y < 256; y += 5) {
    for (int u = 0; u < 256; u += 17) {
      for (int v = 0; v < 256; v += 17) {
        std::fill(planes.y.begin(), planes.y.end(), static_cast<std::uint8_t>(y));
        std::fill(planes.u.begin(), planes.u.end(), static_cast<std::uint8_t>(u));
        std::fill(planes.v.begin(), planes.v.end(), static_cast<std::uint8_t>(v));
        const Image8 image = rgb_from_yuv(planes.picture);
        // ITU-R BT.709-6, items 3.3 and 3.4.
        const double light = (y - 16) / 219.0;
        const double cb = (u - 128) / 224.0;
        const double cr = (v - 128) / 224.0;
        const double red = light + 1.5748 * cr;
        const double blue = light + 1.8556 * cb;
        const double green = (light - 0.2126 * red - 0.0722 * blue) / 0.7152;
        const double expected[] = {red, green, blue};
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(image.at(2, 1)[c], 255.0 * std::clamp(expected[c], 0.0, 1.0), 0.6);
        }
      }
    }
  }
}

TEST(Yuv, HasBlackGreyAndWhiteWhereTheyBelong) {
  Planes planes(2, 2);
  std::fill(planes.u.begin(), planes.u.end(), std::uint8_t{128});
  std::fill(planes.v.begin(), planes.v.end(), std::uint8_t{128});
  planes.y = {16, 235, 0, 255};
  const Image8 image =
      rgb_from_yuv({2, 2, {planes.y.data(), planes.u.data(), planes.v.data()}, {2, 1, 1}});
  EXPECT_EQ(image.channels,
            (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255}));
}

TEST(Yuv, InterpolatesColoursBetweenTheirPlaces) {
  // A ramp of V along x: its samples belong to the even columns.
  Planes planes(32, 4);
  std::fill(planes.y.begin(), planes.y.end(), std::uint8_t{126});
  std::fill(planes.u.begin(), planes.u.end(), std::uint8_t{128});
  for (std::size_t i = 0; i < planes.v.size(); ++i) {
    planes.v[i] = static_cast<std::uint8_t>(100 + 4 * (i % 16));
  }
  const Image8 image = rgb_from_yuv(planes.picture);
  for (int x = 0; x < 31; ++x) {
    const double v = 100.0 + 2.0 * x;
    const double red = (126 - 16) / 219.0 + 1.5748 * (v - 128) / 224.0;
    EXPECT_NEAR(image.at(x, 2)[0], 255.0 * red, 1.0) << x;
  }
}

}  // namespace
}  // namespace mien::render
