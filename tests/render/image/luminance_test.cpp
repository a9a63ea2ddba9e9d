#include "render/image/luminance.h"

#include <gtest/gtest.h>

namespace mien::render {
namespace {

Image8 halves(std::uint8_t left, std::uint8_t right) {
  Image8 picture(64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) std::fill_n(picture.at(x, y), 3, x < 32 ? left : right);
  }
  return picture;
}

TEST(Luminance, OfAFlatPictureIsItsLight) {
  for (const int code : {0, 1, 59, 118, 200, 255}) {
    const auto c = static_cast<std::uint8_t>(code);
    const Luminance found = luminance_of(halves(c, c));
    EXPECT_NEAR(found.mean, linear_from_srgb(code / 255.0), 3e-6);
    EXPECT_NEAR(found.deviation, 0.0, 3e-5);
  }
}

TEST(Luminance, WeighsTheChannelsByTheirBrightness) {
  Image8 picture(1, 1);
  picture.channels = {255, 0, 0};
  EXPECT_NEAR(luminance_of(picture).mean, 0.2126, 2e-6);
  picture.channels = {0, 255, 0};
  EXPECT_NEAR(luminance_of(picture).mean, 0.7152, 2e-6);
  picture.channels = {0, 0, 255};
  EXPECT_NEAR(luminance_of(picture).mean, 0.0722, 2e-6);
}

TEST(Luminance, OfBlackBesideWhiteHasContrastOne) {
  const Luminance found = luminance_of(halves(0, 255));
  EXPECT_NEAR(found.mean, 0.5, 1e-6);
  EXPECT_NEAR(found.deviation, 0.5, 1e-6);
  EXPECT_NEAR(found.rms_contrast(), 1.0, 1e-5);
  EXPECT_EQ(luminance_of(halves(0, 0)).rms_contrast(), 0.0);
}

TEST(Luminance, OfAFilmIsThatOfThePictureItBecomes) {
  Framebuffer framebuffer(64, 64);
  for (std::size_t i = 0; i < framebuffer.channels.size(); ++i) {
    framebuffer.channels[i] = 0.02f + 1.4f * static_cast<float>(i % 997) / 997.0f;
  }
  for (const float stops : {-2.0f, 0.0f, 1.5f}) {
    const Tone tone{.exposure_stops = stops};
    EXPECT_NEAR(mean_luminance(framebuffer, tone), luminance_of(to_srgb8(framebuffer, tone)).mean,
                2e-4);
  }
}

TEST(ClipLuminance, HasMeansAndExtremesOfItsFrames) {
  ClipLuminance clip;
  for (const int code : {100, 200, 150}) {
    clip.add(luminance_of(halves(0, static_cast<std::uint8_t>(code))));
  }
  const auto half = [](int code) { return 0.5 * linear_from_srgb(code / 255.0); };
  EXPECT_EQ(clip.frames, 3);
  EXPECT_NEAR(clip.darkest, half(100), 1e-5);
  EXPECT_NEAR(clip.lightest, half(200), 1e-5);
  EXPECT_NEAR(clip.mean, (half(100) + half(200) + half(150)) / 3.0, 1e-5);
  EXPECT_NEAR(clip.deviation, clip.mean, 1e-5);
  EXPECT_NEAR(clip.rms_contrast, 1.0, 1e-5);
}

}  // namespace
}  // namespace mien::render
