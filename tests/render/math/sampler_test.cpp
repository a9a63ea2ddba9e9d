#include "render/math/sampler.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

/// Pearson's statistic of counts that are expected to be equal.
double chi_squared(const std::vector<int>& counts) {
  double total = 0.0, sum = 0.0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

std::size_t cell_of(float x, unsigned cells) {
  return static_cast<std::size_t>(x * static_cast<float>(cells));
}

// χ² with 255 degrees of freedom lies below 330.5 with probability 0.999.
constexpr double chi_squared_255_at_0_1_percent = 330.5;

TEST(SamplePoint, IsUniformOverSeeds) {
  std::vector<int> counts(256, 0);
  for (std::uint32_t seed = 0; seed < 65536; ++seed) {
    const Point2 p = sample_point(3, seed);
    ++counts[16 * cell_of(p.u, 16) + cell_of(p.v, 16)];
  }
  EXPECT_LT(chi_squared(counts), chi_squared_255_at_0_1_percent);
}

TEST(PixelSampler, IsUniformOverPixels) {
  std::vector<int> counts(256, 0);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      const Point2 p = PixelSampler(7, x, y).point(Dimension::PixelPosition, 0);
      ++counts[16 * cell_of(p.u, 16) + cell_of(p.v, 16)];
    }
  }
  EXPECT_LT(chi_squared(counts), chi_squared_255_at_0_1_percent);
}

/// The variance of the share of samples that fall below a line through the unit square, over many
/// squares of `side` by `side` pixels.
double variance_of_squares(int side, int samples) {
  double sum = 0.0, squares = 0.0;
  constexpr int count = 32;
  for (int square = 0; square < count * count; ++square) {
    int below = 0;
    for (int k = 0; k < side * side * samples; ++k) {
      const int pixel = k / samples;
      const int x = side * (square % count) + pixel % side;
      const int y = side * (square / count) + pixel / side;
      const Point2 p =
          PixelSampler::for_picture(3, x, y, samples).point(Dimension::FirstLight, k % samples);
      below += p.u + 0.7f * p.v < 0.8f ? 1 : 0;
    }
    const double share = below / static_cast<double>(side * side * samples);
    sum += share;
    squares += share * share;
  }
  const double mean = sum / (count * count);
  return squares / (count * count) - mean * mean;
}

TEST(PixelSampler, HasNeighboursThatMakeUpForWhatItLacks) {
  // Four pixels of their own would have a quarter of a pixel's variance; a net of four times as
  // many points has an eighth of it.
  for (const int samples : {4, 16}) {
    const double pixel = variance_of_squares(1, samples);
    EXPECT_LT(pixel, 0.25 / samples) << "and a pixel has less than points at random";
    EXPECT_LT(variance_of_squares(2, samples), pixel / 6.0);
    EXPECT_LT(variance_of_squares(4, samples), pixel / 24.0);
  }
}

TEST(PixelSampler, HasIndependentDimensions) {
  std::vector<int> counts(256, 0);
  for (int x = 0; x < 65536; ++x) {
    const PixelSampler sampler(1, x, 0);
    const float a = sampler.point(Dimension::FloorSkyChoice, 0).u;
    const float b = sampler.point(Dimension::FloorSky, 0).u;
    ++counts[16 * cell_of(a, 16) + cell_of(b, 16)];
  }
  EXPECT_LT(chi_squared(counts), chi_squared_255_at_0_1_percent);
}

/// Whether each of the 2^k boxes of every shape 2^−i × 2^−(k−i) holds one of the points.
bool is_net(const std::vector<Point2>& points, unsigned k) {
  for (unsigned i = 0; i <= k; ++i) {
    std::vector<int> counts(std::size_t{1} << k, 0);
    for (const Point2& p : points) {
      const std::size_t column = cell_of(p.u, 1u << i);
      const std::size_t row = cell_of(p.v, 1u << (k - i));
      if (++counts[(column << (k - i)) + row] > 1) return false;
    }
  }
  return true;
}

TEST(SamplePoint, FillsEachAlignedBlockAsANet) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    for (unsigned k = 0; k <= 8; ++k) {
      for (std::uint32_t block = 0; block < 5; ++block) {
        std::vector<Point2> points;
        for (std::uint32_t i = 0; i < (1u << k); ++i)
          points.push_back(sample_point((block << k) + i, seed));
        EXPECT_TRUE(is_net(points, k)) << "seed " << seed << ", 2^" << k << ", block " << block;
      }
    }
  }
}

TEST(Sobol, StartsWithThePublishedPoints) {
  // Joe & Kuo 2008, first two dimensions, not in Gray-code order.
  constexpr double expected[8][2] = {{0.0, 0.0},     {0.5, 0.5},     {0.25, 0.75},
                                     {0.75, 0.25},   {0.125, 0.625}, {0.625, 0.125},
                                     {0.375, 0.375}, {0.875, 0.875}};
  for (std::uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(sobol(i)[0] * 0x1p-32, expected[i][0]) << i;
    EXPECT_EQ(sobol(i)[1] * 0x1p-32, expected[i][1]) << i;
  }
}

}  // namespace
}  // namespace mien::render
