#include "pipeline/regression/comparison/noise_test.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "motion/error.h"
#include "render/image/image_io.h"

namespace mien::pipeline {

namespace {

/// Quadruple the speed of long doubles, and enough digits for a p value.
using Doubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

constexpr double relative_floor = 1e-4;
constexpr double absolute_floor = 1e-5;

std::size_t blocks_along(int pixels) {
  return static_cast<std::size_t>((pixels + block_pixels - 1) / block_pixels);
}

/// Mean light of each block, three a block.
std::vector<double> block_means(const render::Framebuffer& film) {
  const std::size_t columns = blocks_along(film.width);
  std::vector<double> sums(3 * columns * blocks_along(film.height));
  std::vector<double> pixels(sums.size() / 3);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const std::size_t block = static_cast<std::size_t>(y / block_pixels) * columns +
                                static_cast<std::size_t>(x / block_pixels);
      for (std::size_t c = 0; c < 3; ++c) sums[3 * block + c] += film.at(x, y)[c];
      pixels[block] += 1.0;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= pixels[i / 3];
  return sums;
}

/// The test of one colour of a block: Welch's t with the degrees of freedom of Satterthwaite,
/// two-sided.
struct ColourTest {
  std::size_t at = 0;  ///< in the statistics
  double t = 0.0;
  double p = 1.0;
};

ColourTest tested(const BlockStatistics& a, const BlockStatistics& b, std::size_t i) {
  const double floor = std::max(absolute_floor, relative_floor * std::max(a.mean[i], b.mean[i]));
  const double difference = double{b.mean[i]} - double{a.mean[i]};
  if (std::abs(difference) <= floor) return {.at = i};
  const double of_a = a.variance[i] / a.patterns + floor * floor / 2.0;
  const double of_b = b.variance[i] / b.patterns + floor * floor / 2.0;
  const double both = of_a + of_b;
  const double degrees =
      both * both / (of_a * of_a / (a.patterns - 1) + of_b * of_b / (b.patterns - 1));
  const double t = difference / std::sqrt(both);
  return {i, t,
          2.0 * cdf(boost::math::students_t_distribution<double, Doubles>(degrees), -std::abs(t))};
}

bool has_noise(const BlockStatistics& blocks, std::size_t i) {
  return blocks.variance[i] > absolute_floor * absolute_floor;
}

/// The square of the normal score of a two-sided p.
double squared_score(double p) {
  constexpr double least = 1e-300;
  const double z =
      quantile(boost::math::normal_distribution<double, Doubles>(), std::max(p, least) / 2.0);
  return z * z;
}

/// 1 − (1 − p)^n, also where p is tiny.
double corrected(double p, double n) {
  return -std::expm1(n * std::log1p(-std::min(p, 1.0 - 1e-16)));
}

/// A test for each block and colour with noise, or a difference.
std::vector<ColourTest> tests_of(const BlockStatistics& before, const BlockStatistics& now) {
  std::vector<ColourTest> tests;
  for (std::size_t i = 0; i < before.count(); ++i) {
    const ColourTest colour = tested(before, now, i);
    if (colour.p < 1.0 || has_noise(before, i) || has_noise(now, i)) tests.push_back(colour);
  }
  return tests;
}

/// χ² over the blocks, each with the mean of its colours' scores.
double p_of_all(const std::vector<ColourTest>& colours) {
  double scores = 0.0;
  std::size_t blocks = 0;
  for (std::size_t first = 0, end = 0; first < colours.size(); first = end, ++blocks) {
    double block = 0.0;
    while (end < colours.size() && colours[end].at / 3 == colours[first].at / 3)
      block += squared_score(colours[end++].p);
    scores += block / static_cast<double>(end - first);
  }
  const auto degrees = static_cast<double>(blocks);
  // Images that are equal or nearly so: 1 - p is below exp(-0.3 * degrees), and Boost's series for
  // it overflows above 341 degrees of freedom.
  if (degrees > 200.0 && scores < 0.25 * degrees) return 1.0;
  return cdf(complement(boost::math::chi_squared_distribution<double, Doubles>(degrees), scores));
}

}  // namespace

BlockStatistics block_statistics(const std::vector<render::Framebuffer>& patterns) {
  BlockStatistics blocks{.columns = static_cast<int>(blocks_along(patterns.front().width)),
                         .rows = static_cast<int>(blocks_along(patterns.front().height)),
                         .patterns = static_cast<int>(patterns.size()),
                         .mean = {},
                         .variance = {}};
  std::vector<double> sum, squares;
  for (const render::Framebuffer& film : patterns) {
    const std::vector<double> means = block_means(film);
    if (sum.empty()) sum.assign(means.size(), 0.0);
    for (std::size_t i = 0; i < means.size(); ++i) sum[i] += means[i];
  }
  const auto n = static_cast<double>(patterns.size());
  squares.assign(sum.size(), 0.0);
  for (const render::Framebuffer& film : patterns) {
    const std::vector<double> means = block_means(film);
    for (std::size_t i = 0; i < means.size(); ++i) {
      const double off = means[i] - sum[i] / n;
      squares[i] += off * off;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    blocks.mean.push_back(static_cast<float>(sum[i] / n));
    blocks.variance.push_back(static_cast<float>(squares[i] / (n - 1.0)));
  }
  return blocks;
}

void write_blocks(const std::filesystem::path& file, const BlockStatistics& blocks) {
  render::Framebuffer film(blocks.columns, 2 * blocks.rows);
  std::ranges::copy(blocks.mean, film.channels.begin());
  std::ranges::copy(blocks.variance,
                    film.channels.begin() + static_cast<std::ptrdiff_t>(blocks.count()));
  render::write_exr(file, film, render::ExrDepth::Float);
}

BlockStatistics read_blocks(const std::filesystem::path& file) {
  const render::Framebuffer film = render::read_exr(file);
  const auto half = static_cast<std::ptrdiff_t>(film.channels.size() / 2);
  BlockStatistics blocks{.columns = film.width,
                         .rows = film.height / 2,
                         .patterns = noise_patterns,
                         .mean = {film.channels.begin(), film.channels.begin() + half},
                         .variance = {film.channels.begin() + half, film.channels.end()}};
  const auto is_wrong = [](float value) { return !std::isfinite(value) || value < 0.0f; };
  if (film.height % 2 != 0 || std::ranges::any_of(film.channels, is_wrong))
    throw std::runtime_error("contains no block statistics");
  return blocks;
}

NoiseTest noise_test(const BlockStatistics& before, const BlockStatistics& now,
                     std::size_t pictures, double false_alarms) {
  if (before.columns != now.columns || before.rows != now.rows)
    throw Error("images of different sizes cannot be compared with noise",
                "compare images of one size");
  const std::vector<ColourTest> colours = tests_of(before, now);
  NoiseTest test{.tests = colours.size()};
  if (colours.empty()) return test;
  const double alarms =
      false_alarms / 2.0 / static_cast<double>(std::max<std::size_t>(pictures, 1));
  const auto n = static_cast<double>(colours.size());
  for (const ColourTest& colour : colours) {
    test.least_p = std::min(test.least_p, colour.p);
    if (std::abs(colour.t) > std::abs(test.largest_t)) test.largest_t = colour.t;
    if (corrected(colour.p, n) >= alarms) continue;
    ++test.outside;
    const double light = std::max<double>(before.mean[colour.at], absolute_floor);
    const double bias = std::abs(now.mean[colour.at] - before.mean[colour.at]) / light;
    test.largest_bias = std::max(test.largest_bias, bias);
  }
  test.together_p = p_of_all(colours);
  test.is_bias = test.outside > 0 || test.together_p < alarms;
  return test;
}

}  // namespace mien::pipeline
