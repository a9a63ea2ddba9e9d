#include "render/compare/perceptual_filters.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

constexpr double pixels_per_degree = 67.0206;

double sum_of(const HalfKernel& kernel) {
  double sum = kernel[0];
  for (std::size_t k = 1; k < kernel.size(); ++k) sum += 2.0 * static_cast<double>(kernel[k]);
  return sum;
}

/// What is left of a grating of that many cycles a degree.
double response(const HalfKernel& kernel, double frequency) {
  double sum = kernel[0];
  for (std::size_t k = 1; k < kernel.size(); ++k)
    sum +=
        2.0 * static_cast<double>(kernel[k]) *
        std::cos(2.0 * std::numbers::pi * frequency * static_cast<double>(k) / pixels_per_degree);
  return sum;
}

TEST(PerceptualFilters, KeepWhatIsEven) {
  for (const double ppd : {20.0, pixels_per_degree, 150.0}) {
    const ContrastFilters filters = contrast_filters(ppd);
    for (const HalfKernel* kernel : {&filters.achromatic, &filters.red_green, &filters.blue_yellow,
                                     &filters.blue_yellow_narrow})
      EXPECT_NEAR(sum_of(*kernel), 1.0, 1e-6);
    EXPECT_NEAR(sum_of(feature_filters(ppd).smooth), 1.0, 1e-6);
    EXPECT_NEAR(sum_of(feature_filters(ppd).point), 0.0, 1e-6);
  }
}

// A Gaussian exp(−π² d² / b) lets exp(−b f²) of f cycles a degree through: the paper's table 1.
TEST(PerceptualFilters, HaveTheSensitivityOfTheEye) {
  const ContrastFilters filters = contrast_filters(pixels_per_degree);
  for (const double f : {1.0, 3.0, 8.0, 15.0}) {
    EXPECT_NEAR(response(filters.achromatic, f), std::exp(-0.0047 * f * f), 1e-3);
    EXPECT_NEAR(response(filters.red_green, f), std::exp(-0.0053 * f * f), 1e-3);
    // These are cut at three and four standard deviations.
    const double blue = filters.wide_share * response(filters.blue_yellow, f) +
                        (1.0 - filters.wide_share) * response(filters.blue_yellow_narrow, f);
    const double expected =
        (34.1 * std::exp(-0.04 * f * f) + 13.5 * std::exp(-0.025 * f * f)) / 47.6;
    // The two spatial Gaussians are normalised together, whose one-dimensional integrals the paper
    // gives; in two dimensions their shares shift towards the wide one.
    const double wide = 34.1 * std::sqrt(0.04), narrow = 13.5 * std::sqrt(0.025);
    const double plane =
        (wide * std::exp(-0.04 * f * f) + narrow * std::exp(-0.025 * f * f)) / (wide + narrow);
    EXPECT_NEAR(blue, plane, 6e-3);
    EXPECT_NEAR(blue, expected, 0.03);
  }
}

TEST(PerceptualFilters, ReachThreeDeviationsOfTheWidest) {
  // 3 · √(0.04 / 2) / π · 67.02 = 9.05 and 3 · 0.041 · 67.02 = 8.24 pixels
  EXPECT_EQ(reach_of(contrast_filters(pixels_per_degree).achromatic), 10);
  EXPECT_EQ(reach_of(contrast_filters(pixels_per_degree).blue_yellow), 10);
  EXPECT_EQ(reach_of(feature_filters(pixels_per_degree).edge), 9);
}

// A step between two pixels: the sum of the weights of one side.
TEST(PerceptualFilters, AnswerToAStepWithOne) {
  const FeatureFilters filters = feature_filters(pixels_per_degree);
  double side = 0.0;
  for (const float weight : filters.edge) side += static_cast<double>(weight);
  EXPECT_NEAR(side, 1.0, 1e-6);
  std::vector<float> line(64, 0.0f), found(16);
  for (std::size_t i = 32; i < 64; ++i) line[i] = 1.0f;
  filter_odd(filters.edge, line.data() + 24, 1, 16, found.data());
  EXPECT_NEAR(found[8], 1.0f, 1e-6f);  // the first pixel of the bright side
  EXPECT_NEAR(found[7], 1.0f, 1e-6f);  // and the last of the dark one: the centre has no weight
  EXPECT_NEAR(
      found[0],
      1.0f -
          [&] {
            float inner = 0.0f;
            for (std::size_t k = 0; k < 8; ++k) inner += filters.edge[k];
            return inner;
          }(),
      1e-6f);
}

// A line one pixel wide: the weight of the centre, which is (−1) of Σ |negative weights|.
TEST(PerceptualFilters, AnswerToALineWithTheShareOfTheCentre) {
  const FeatureFilters filters = feature_filters(pixels_per_degree);
  const double deviation = 0.041 * pixels_per_degree;
  double negative = 0.0;
  for (int k = -9; k <= 9; ++k) {
    const double weight =
        (k * k / (deviation * deviation) - 1.0) * std::exp(-0.5 * k * k / (deviation * deviation));
    if (weight < 0.0) negative -= weight;
  }
  std::vector<float> line(64, 0.0f), found(16);
  line[32] = 1.0f;
  filter_even(filters.point, line.data() + 24, 1, 16, found.data());
  EXPECT_NEAR(found[8], -1.0 / negative, 1e-6);
}

TEST(PerceptualFilters, MirrorWithTheirLine) {
  const FeatureFilters filters = feature_filters(pixels_per_degree);
  std::vector<float> line(64), mirrored(64), found(16), other(16);
  for (std::size_t i = 0; i < 64; ++i) line[i] = std::sin(0.3f * static_cast<float>(i * i));
  for (std::size_t i = 0; i < 64; ++i) mirrored[i] = line[63 - i];
  filter_even(filters.point, line.data() + 24, 1, 16, found.data());
  filter_even(filters.point, mirrored.data() + 24, 1, 16, other.data());
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(found[i], other[15 - i]);
}

}  // namespace
}  // namespace mien::render
