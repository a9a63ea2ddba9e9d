#include "render/image/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

Framebuffer film_of(float light, int width = 1, int height = 1) {
  Framebuffer framebuffer(width, height);
  framebuffer.channels.assign(framebuffer.channels.size(), light);
  return framebuffer;
}

TEST(ToneCurve, LeavesEverythingBelowItsShoulderAlone) {
  EXPECT_EQ(tone_curve(0.18f, 0.8f), 0.18f);
  EXPECT_EQ(tone_curve(0.8f, 0.8f), 0.8f);
  EXPECT_EQ(tone_curve(0.0f, 0.8f), 0.0f);
}

TEST(ToneCurve, RisesBelowOneAboveItsShoulder) {
  float before = 0.8f;
  for (float light = 0.81f; light < 50.0f; light *= 1.1f) {
    const float shown = tone_curve(light, 0.8f);
    EXPECT_GT(shown, before);
    EXPECT_LT(shown, 1.0f);
    before = shown;
  }
}

TEST(ToneCurve, LeavesItsShoulderWithSlopeOne) {
  EXPECT_NEAR(tone_curve(0.801f, 0.8f) - 0.8f, 0.001f, 1e-5f);
}

TEST(ToneCurve, ClipsWithAShoulderOfOneAndSendsNoLightToBlack) {
  EXPECT_EQ(tone_curve(3.0f, 1.0f), 1.0f);
  EXPECT_EQ(tone_curve(-1.0f, 0.8f), 0.0f);
  EXPECT_EQ(tone_curve(std::numeric_limits<float>::quiet_NaN(), 0.8f), 0.0f);
  EXPECT_EQ(tone_curve(std::numeric_limits<float>::infinity(), 0.8f), 1.0f);
}

TEST(Srgb, HasThePublishedValues) {
  // IEC 61966-2-1: the two pieces meet, and 18 % grey is encoded as 118 of 255.
  EXPECT_NEAR(srgb_from_linear(0.0031308), 0.04045, 1e-6);
  EXPECT_NEAR(255.0 * srgb_from_linear(0.18), 117.6, 0.05);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.2140, 1e-4);
  EXPECT_DOUBLE_EQ(srgb_from_linear(1.0), 1.0);
}

TEST(Srgb, IsUndoneByItsInverse) {
  for (int i = 0; i <= 1000; ++i) {
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 1000.0)), i / 1000.0, 1e-6);
  }
}

TEST(Srgb8, KeepsEveryCode) {
  Framebuffer framebuffer(256, 1);
  for (int code = 0; code < 256; ++code) {
    const Color light = linear_from_srgb8(code, code, code);
    std::copy_n(light.data(), 3, framebuffer.at(code, 0));
  }
  const Image8 image = to_srgb8(framebuffer, {.shoulder = 1.0f});
  for (int code = 0; code < 256; ++code) EXPECT_EQ(image.at(code, 0)[1], code);
}

Image16 to_srgb16(const Framebuffer& framebuffer, const Tone& tone = {}) {
  Image16 picture(framebuffer.width, framebuffer.height);
  develop(framebuffer, {0, 0, framebuffer.width, framebuffer.height}, tone, picture, 0, 0);
  return picture;
}

TEST(Srgb16, RoundsToTheNearestCode) {
  for (float light = 0.0f; light < 0.8f; light += 0.00713f) {
    const double exact = 65535.0 * srgb_from_linear(static_cast<double>(light));
    EXPECT_NEAR(to_srgb16(film_of(light)).channels[0], exact, 0.51);
  }
}

/// The code that the definition gives: as many codes as have their threshold at or below the light.
int counted_code(float light, int top, double rounding) {
  int code = 0;
  while (code < top && light >= static_cast<float>(linear_from_srgb((code + rounding) / top))) {
    ++code;
  }
  return code;
}

TEST(Srgb8, HasTheCodesOfItsThresholdsOnBothSidesOfEach) {
  std::vector<float> lights = {0.0f, -1.0f, 1e-30f, 1.0f, 0.99999994f};
  for (int code = 1; code <= 255; ++code) {
    const auto threshold = static_cast<float>(linear_from_srgb((code - 0.5) / 255.0));
    lights.push_back(threshold);
    lights.push_back(std::nextafter(threshold, 0.0f));
    lights.push_back(std::nextafter(threshold, 1.0f));
  }
  for (float light = 1e-5f; light < 1.0f; light *= 1.0007f) lights.push_back(light);
  Framebuffer framebuffer(static_cast<int>(lights.size()), 1);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    std::fill_n(framebuffer.at(static_cast<int>(i), 0), 3, lights[i]);
  }
  const Image8 image = to_srgb8(framebuffer, {.shoulder = 1.0f});
  for (std::size_t i = 0; i < lights.size(); ++i) {
    EXPECT_EQ(image.at(static_cast<int>(i), 0)[1], counted_code(lights[i], 255, 0.5)) << lights[i];
  }
}

TEST(Exposure, DoublesTheLightWithEachStop) {
  EXPECT_EQ(to_srgb16(film_of(0.1f), {.exposure_stops = 2.0f}), to_srgb16(film_of(0.4f)));
}

TEST(Dither, KeepsTheMeanOfALightBetweenTwoCodes) {
  const float light = static_cast<float>(linear_from_srgb(100.3 / 255.0));
  const Image8 image = to_srgb8(film_of(light, 64, 64), {.dither = true});
  double sum = 0.0;
  for (const auto code : image.channels) {
    EXPECT_TRUE(code == 100 || code == 101);
    sum += code;
  }
  EXPECT_NEAR(sum / static_cast<double>(image.channels.size()), 100.3, 1.0 / 64.0);
}

// Random light from black to far above the shoulder, in a picture of 37 x 21 cut at odd places.
template <class Picture>
void expect_parts_to_make(const Picture& whole, const Framebuffer& framebuffer, const Tone& tone) {
  constexpr int right = 5, down = 3;
  Picture found(framebuffer.width + right, framebuffer.height + down);
  constexpr std::array columns{0, 16, 29, 37}, rows{0, 8, 17, 21};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < 3; ++k) {
      const int x = columns[k], y = rows[row];
      develop(framebuffer, {x, y, columns[k + 1] - x, rows[row + 1] - y}, tone, found, x + right,
              y + down);
    }
  for (int y = 0; y < found.height; ++y) {
    for (int x = 0; x < found.width; ++x) {
      const bool is_part = x >= right && y >= down;
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(found.at(x, y)[c], is_part ? whole.at(x, y)[c] : 0) << x << ", " << y;
    }
  }
}

Framebuffer random_film(int width, int height) {
  Framebuffer framebuffer(width, height);
  std::mt19937 random(7);
  std::lognormal_distribution<float> light(-1.5f, 1.0f);
  for (float& channel : framebuffer.channels) channel = light(random);
  return framebuffer;
}

TEST(Development, GivesPartsTheCodesThatTheyHaveInTheWholePicture) {
  const Framebuffer framebuffer = random_film(37, 21);
  // The same film further to the right and down, as dither counts from the picture's corner.
  Framebuffer moved(framebuffer.width + 5, framebuffer.height + 3);
  for (int y = 0; y < framebuffer.height; ++y)
    std::copy_n(framebuffer.at(0, y), 3 * framebuffer.width, moved.at(5, y + 3));
  for (const Tone& tone : {Tone{}, Tone{.exposure_stops = 1.0f}, Tone{.dither = true}}) {
    expect_parts_to_make(to_srgb8(moved, tone), framebuffer, tone);
    expect_parts_to_make(to_srgb16(moved, tone), framebuffer, tone);
  }
}

}  // namespace
}  // namespace mien::render
