#include "render/compare/perceptual_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "render/compare/paper_formulas.h"
#include "render/refusal.h"

namespace mien::render {
namespace {

Image8 uniform(int width, int height, std::array<int, 3> color) {
  Image8 image(width, height);
  for (std::size_t i = 0; i < image.channels.size(); ++i)
    image.channels[i] = static_cast<std::uint8_t>(color[i % 3]);
  return image;
}

/// Soft stripes and a few hard edges.
Image8 scenery(int width, int height, int shift = 0) {
  Image8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int u = x + shift;
      const bool box = u % 40 > 12 && u % 40 < 25 && y % 30 > 8;
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(
            box ? 200 - 60 * c : 110 + 50 * std::sin(0.11 * u + 0.07 * y * (c + 1)));
    }
  }
  return image;
}

Image8 noisy(Image8 image, int amplitude) {
  std::mt19937 random(3);
  for (std::uint8_t& channel : image.channels) {
    const int step = static_cast<int>(random() % 2001u) - 1000;
    channel = static_cast<std::uint8_t>(std::clamp(channel + amplitude * step / 1000, 0, 255));
  }
  return image;
}

Image8 blurred(const Image8& image, int radius) {
  Image8 result(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int k = -radius; k <= radius; ++k)
          sum += image.at(std::clamp(x + k, 0, image.width - 1), y)[c];
        result.at(x, y)[c] = static_cast<std::uint8_t>(sum / (2 * radius + 1));
      }
  return result;
}

double mean_error(const Image8& a, const Image8& b, const Viewing& viewing = {}) {
  return summary_of(perceptual_error(a, b, viewing)).mean;
}

TEST(PerceptualError, OfUniformColorsIsWorkedOutByHand) {
  const std::array<int, 3> black = {0, 0, 0}, white = {255, 255, 255};
  // 100 of lightness to the power of 0.7 is 25.12; the largest is 203.3^0.7 = 41.27; knee 16.51.
  const PixelMap map = perceptual_error(uniform(37, 21, black), uniform(37, 21, white));
  for (const float error : map.values) EXPECT_NEAR(error, 0.95 + 0.05 * 8.61 / 24.76, 2e-4);
  // L of code 128 is 53.585, of 118 is 49.62: 3.96^0.7 · 0.95 / 16.51
  EXPECT_NEAR(mean_error(uniform(9, 9, {128, 128, 128}), uniform(9, 9, {118, 118, 118})),
              std::pow(53.585 - 49.616, 0.7) * 0.95 / 16.507, 1e-3);
  // Green and blue are the furthest apart.
  EXPECT_NEAR(mean_error(uniform(9, 9, {0, 255, 0}), uniform(9, 9, {0, 0, 255})), 1.0, 1e-6);
  const auto color = [](std::array<int, 3> c) {
    return test::paper::hunt_lab(
        {test::paper::linear(c[0]), test::paper::linear(c[1]), test::paper::linear(c[2])});
  };
  const std::array<int, 3> colors[] = {{255, 0, 0}, {12, 200, 90}, {30, 30, 31}, {250, 250, 0}};
  for (const auto& p : colors)
    for (const auto& q : colors)
      EXPECT_NEAR(mean_error(uniform(5, 4, p), uniform(5, 4, q)),
                  test::paper::color_error(color(p), color(q)), p == q ? 0.0 : 1e-4);
}

TEST(PerceptualError, IsThatOfTheFormulasInTwoDimensions) {
  const Image8 a = scenery(34, 27), b = noisy(scenery(34, 27, 2), 60);
  for (const double distance : {0.35, 0.7}) {
    const Viewing viewing{.distance_metres = distance};
    const PixelMap expected = test::paper::error(a, b, viewing.pixels_per_degree());
    const PixelMap found = perceptual_error(a, b, viewing);
    for (std::size_t i = 0; i < found.values.size(); ++i)
      ASSERT_NEAR(found.values[i], expected.values[i], 2e-4f) << i;
    EXPECT_NEAR(summary_of(found).mean, summary_of(expected).mean, 1e-5);
  }
}

TEST(PerceptualError, IsNothingForEqualPicturesAndSymmetric) {
  const Image8 a = scenery(300, 90), b = noisy(a, 30);
  EXPECT_EQ(summary_of(perceptual_error(a, a)).largest, 0.0);
  EXPECT_EQ(perceptual_error(a, b), perceptual_error(b, a));
}

TEST(PerceptualError, GrowsWithNoiseBlurAndShift) {
  const Image8 a = scenery(160, 90);
  double noise = 0.0, blur = 0.0, shift = 0.0;
  for (const int step : {1, 2, 4, 8}) {
    const double noisier = mean_error(a, noisy(a, 8 * step));
    const double softer = mean_error(a, blurred(a, step));
    const double further = mean_error(a, scenery(160, 90, step));
    EXPECT_GT(noisier, 1.1 * noise);
    EXPECT_GT(softer, 1.1 * blur);
    EXPECT_GT(further, 1.1 * shift);
    noise = noisier;
    blur = softer;
    shift = further;
  }
}

TEST(PerceptualError, OfFineNoiseShrinksWithTheDistance) {
  const Image8 a = uniform(96, 64, {128, 128, 128}), b = noisy(a, 40);
  double nearer = 1.0;
  for (const double distance : {0.2, 0.4, 0.8, 1.6}) {
    const double error = mean_error(a, b, {.distance_metres = distance});
    EXPECT_LT(error, nearer);
    nearer = error;
  }
}

TEST(PerceptualError, IsTheSameWithAnyNumberOfThreadsAndMirrorsWithThePictures) {
  const Image8 a = scenery(533, 150), b = noisy(a, 20);
  const PixelMap alone = perceptual_error(a, b, {}, 1);
  EXPECT_EQ(alone, perceptual_error(a, b, {}, 2));
  EXPECT_EQ(alone, perceptual_error(a, b, {}, 7));
  const auto mirrored = [](const Image8& image) {
    Image8 other(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        std::copy_n(image.at(image.width - 1 - x, y), 3, other.at(x, y));
    return other;
  };
  const PixelMap other = perceptual_error(mirrored(a), mirrored(b));
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) ASSERT_EQ(alone.at(x, y), other.at(a.width - 1 - x, y));
}

/// Grain, the same in all but a box of pixels, which is lighter in the second.
Image8 grain_with_box(int x, int y, int edge, int lighter) {
  Image8 picture(700, 300);
  std::mt19937 random(5);
  for (std::uint8_t& channel : picture.channels)
    channel = static_cast<std::uint8_t>(100 + random() % 40);
  for (int j = y; j < y + edge; ++j)
    for (int i = x; i < x + edge; ++i) picture.at(i, j)[1] += static_cast<std::uint8_t>(lighter);
  return picture;
}

// Where nothing differs nothing is worked out: beside a change elsewhere the numbers are the same.
TEST(PerceptualError, OfAPartIsTheSameWhateverDiffersFarAway) {
  const Image8 plain = grain_with_box(0, 0, 0, 0);
  for (const int x : {0, 250, 254, 690}) {
    const PixelMap alone = perceptual_error(plain, grain_with_box(x, 60, 9, 30));
    Image8 both = grain_with_box(x, 60, 9, 30);
    for (int far = 0; far < 700; far += 100) both.at(far, 290)[0] += 50;
    const PixelMap together = perceptual_error(plain, both);
    for (int row = 0; row < 200; ++row)
      for (int column = 0; column < 700; ++column)
        ASSERT_EQ(alone.at(column, row), together.at(column, row)) << column << ", " << row;
    EXPECT_GT(alone.at(std::min(x + 4, 699), 64), 0.0f);
    EXPECT_EQ(alone.at((x + 350) % 700, 250), 0.0f);
  }
}

TEST(PerceptualError, OfOnePixelIsThatOfItsColor) {
  EXPECT_NEAR(mean_error(uniform(1, 1, {0, 0, 0}), uniform(1, 1, {255, 255, 255})), 0.9674, 2e-4);
}

TEST(PerceptualError, IsRefusedForOtherSizesAndEyes) {
  const Image8 a(4, 3), b(3, 4);
  EXPECT_EQ(test::refusal_of([&] { perceptual_error(a, b); }),
            "the pictures differ in size: 4 x 3 and 3 x 4 pixels");
  EXPECT_THROW(perceptual_error(a, a, {.distance_metres = 0.0}), std::invalid_argument);
  EXPECT_THROW(perceptual_error(a, a, {.screen_metres = 0.0}), std::invalid_argument);
}

TEST(ErrorSummary, WeighsPixelsByTheirError) {
  PixelMap map(5, 2);
  map.values = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.125f, 0.125f, 0.25f, 0.5f};
  const ErrorSummary summary = summary_of(map);
  EXPECT_DOUBLE_EQ(summary.mean, 0.1);
  EXPECT_EQ(summary.least, 0.0);
  EXPECT_EQ(summary.largest, 0.5);
  EXPECT_EQ(summary.largest_x, 4);
  EXPECT_EQ(summary.largest_y, 1);
  EXPECT_EQ(summary.weighted_first_quartile, 0.125);
  EXPECT_EQ(summary.weighted_median, 0.25);
  EXPECT_EQ(summary.weighted_third_quartile, 0.5);
  EXPECT_EQ(summary_of(PixelMap(3, 3)).weighted_median, 0.0);
}

TEST(Viewing, OfThePaperHas67PixelsADegree) {
  EXPECT_NEAR(Viewing{}.pixels_per_degree(), 67.0206, 1e-4);
}

}  // namespace
}  // namespace mien::render
