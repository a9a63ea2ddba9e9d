#include "render/video/yuv.h"

#include <algorithm>
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

TEST(Yuv, OfRgbIsTheNearestCodeOfBt709) {
  Planes planes(4, 4);
  const Yuv420Planes out{{planes.y.data(), planes.u.data(), planes.v.data()}, {4, 2, 2}};
  for (int r = 0; r < 256; r += 15) {
    for (int g = 0; g < 256; g += 15) {
      for (int b = 0; b < 256; b += 15) {
        Image8 image(4, 4);
        for (std::size_t i = 0; i < image.channels.size(); i += 3) {
          image.channels[i] = static_cast<std::uint8_t>(r);
          image.channels[i + 1] = static_cast<std::uint8_t>(g);
          image.channels[i + 2] = static_cast<std::uint8_t>(b);
        }
        yuv_from_rgb(image, out);
        const double light = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
        EXPECT_NEAR(planes.y[5], 16.0 + 219.0 * light, 0.51);
        EXPECT_NEAR(planes.u[3], 128.0 + 224.0 * (b / 255.0 - light) / 1.8556, 0.51);
        EXPECT_NEAR(planes.v[0], 128.0 + 224.0 * (r / 255.0 - light) / 1.5748, 0.51);
        if (r == g && g == b) {
          EXPECT_EQ(planes.u[1], 128) << r;
        }
      }
    }
  }
}

TEST(Yuv, ComesBackFromRgbAsItWas) {
  // Smooth, so that halved colours lose little.
  Image8 image(32, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      image.at(x, y)[0] = static_cast<std::uint8_t>(60 + 3 * x);
      image.at(x, y)[1] = static_cast<std::uint8_t>(90 + 5 * y);
      image.at(x, y)[2] = static_cast<std::uint8_t>(200 - 2 * x - 3 * y);
    }
  Planes planes(32, 16);
  yuv_from_rgb(image, {{planes.y.data(), planes.u.data(), planes.v.data()}, {32, 16, 16}});
  planes.picture.strides[0] = 32;
  const Image8 back = rgb_from_yuv(planes.picture);
  for (int y = 2; y < 14; ++y)
    for (int x = 2; x < 30; ++x)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.at(x, y)[c], image.at(x, y)[c], 3.0) << x << y;
  const Image8 rows = rgb_from_yuv(planes.picture, 4);
  ASSERT_EQ(rows.height, 4);
  for (int y = 0; y < 4; ++y)
    EXPECT_TRUE(std::equal(rows.at(0, y), rows.at(0, y) + 3 * 32, back.at(0, 4 * y)));
}

}  // namespace
}  // namespace mien::render
