#include "render/compare/structural_similarity.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "render/refusal.h"

namespace mien::render {
namespace {

Image8 grey(int width, int height, int code) {
  Image8 image(width, height);
  std::fill(image.channels.begin(), image.channels.end(), static_cast<std::uint8_t>(code));
  return image;
}

Image8 random_picture(int width, int height, unsigned seed) {
  Image8 image(width, height);
  std::mt19937 random(seed);
  for (std::uint8_t& channel : image.channels) channel = static_cast<std::uint8_t>(random());
  return image;
}

double luma(const Image8& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

/// As the paper writes it, with deviations from the means.
double similarity_at(const Image8& a, const Image8& b, int x, int y) {
  double whole = 0.0, mean_a = 0.0, mean_b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  const auto each = [&](const auto& add) {
    for (int dy = -5; dy <= 5; ++dy)
      for (int dx = -5; dx <= 5; ++dx)
        add(std::exp(-(dx * dx + dy * dy) / 4.5), luma(a, x + dx, y + dy), luma(b, x + dx, y + dy));
  };
  each([&](double w, double p, double q) { whole += w, mean_a += w * p, mean_b += w * q; });
  mean_a /= whole;
  mean_b /= whole;
  each([&](double w, double p, double q) {
    aa += w / whole * (p - mean_a) * (p - mean_a);
    bb += w / whole * (q - mean_b) * (q - mean_b);
    ab += w / whole * (p - mean_a) * (q - mean_b);
  });
  const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
  return (2.0 * mean_a * mean_b + c1) * (2.0 * ab + c2) /
         ((mean_a * mean_a + mean_b * mean_b + c1) * (aa + bb + c2));
}

TEST(StructuralSimilarity, OfConstantPicturesIsThatOfTheirMeans) {
  const double c1 = 2.55 * 2.55;
  for (const auto& [p, q] : {std::pair(0, 255), std::pair(100, 110), std::pair(40, 200)}) {
    const double expected = (2.0 * p * q + c1) / (1.0 * p * p + 1.0 * q * q + c1);
    EXPECT_NEAR(structural_similarity(grey(30, 20, p), grey(30, 20, q)).mean, expected, 2e-3);
  }
}

TEST(StructuralSimilarity, IsThatOfThePapersFormula) {
  const Image8 a = random_picture(25, 19, 1);
  Image8 b = random_picture(25, 19, 2);
  for (std::size_t i = 0; i < b.channels.size(); ++i)
    b.channels[i] = static_cast<std::uint8_t>((3 * a.channels[i] + b.channels[i]) / 4);
  const StructuralSimilarity found = structural_similarity(a, b);
  double sum = 0.0;
  for (int y = 5; y < 14; ++y) {
    for (int x = 5; x < 20; ++x) {
      const double expected = similarity_at(a, b, x, y);
      EXPECT_NEAR(found.map.at(x, y), expected, 1e-4);
      sum += expected;
    }
  }
  EXPECT_NEAR(found.mean, sum / (9 * 15), 1e-5);
}

TEST(StructuralSimilarity, IsOneForEqualPicturesSymmetricAndBelowZeroForNegatives) {
  const Image8 a = random_picture(40, 33, 5), b = random_picture(40, 33, 6);
  Image8 negative = a;
  for (std::uint8_t& channel : negative.channels)
    channel = static_cast<std::uint8_t>(255 - channel);
  EXPECT_EQ(structural_similarity(a, a).mean, 1.0);
  EXPECT_EQ(structural_similarity(a, b).map, structural_similarity(b, a).map);
  EXPECT_LT(structural_similarity(a, negative).mean, -0.5);
}

TEST(StructuralSimilarity, IsKnownOfPicturesSmallerThanAWindow) {
  EXPECT_EQ(structural_similarity(grey(3, 2, 9), grey(3, 2, 9)).mean, 1.0);
  EXPECT_EQ(test::refusal_of([] { structural_similarity(grey(3, 2, 0), grey(3, 3, 0)); }),
            "the pictures differ in size: 3 x 2 and 3 x 3 pixels");
}

}  // namespace
}  // namespace mien::render
