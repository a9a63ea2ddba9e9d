#include "render/image/resize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "render/image/tone.h"

namespace mien::render {

namespace {

constexpr double kernel_radius = 2.0;

/// Mitchell and Netravali 1988, B = C = 1/3.
double mitchell(double x) {
  x = std::abs(x);
  if (x < 1.0) return (7.0 * x * x * x - 12.0 * x * x + 16.0 / 3.0) / 6.0;
  if (x < 2.0) {
    return (-7.0 / 3.0 * x * x * x + 12.0 * x * x - 20.0 * x + 32.0 / 3.0) / 6.0;
  }
  return 0.0;
}

/// The source pixels that one target pixel is made of, and their weights.
struct Taps {
  int first = 0;
  std::vector<double> weights;
};

std::vector<Taps> taps_of(int from, int to) {
  const double scale = static_cast<double>(from) / to;
  const double widened = std::max(1.0, scale);
  std::vector<Taps> taps;
  for (int i = 0; i < to; ++i) {
    const double centre = (i + 0.5) * scale - 0.5;
    Taps tap;
    tap.first = static_cast<int>(std::ceil(centre - kernel_radius * widened));
    const int last = static_cast<int>(std::floor(centre + kernel_radius * widened));
    double sum = 0.0;
    for (int s = tap.first; s <= last; ++s) {
      tap.weights.push_back(mitchell((s - centre) / widened));
      sum += tap.weights.back();
    }
    for (double& weight : tap.weights) weight /= sum;
    taps.push_back(std::move(tap));
  }
  return taps;
}

std::array<double, 256> linear_table() {
  std::array<double, 256> table{};
  for (int code = 0; code < 256; ++code) {
    table[static_cast<std::size_t>(code)] = linear_from_srgb(code / 255.0);
  }
  return table;
}

}  // namespace

Image8 resized(const Image8& image, int width, int height) {
  if (width < 1 || height < 1 || image.width < 1 || image.height < 1) {
    throw std::invalid_argument("resized: a size is not positive");
  }
  const std::array<double, 256> linear = linear_table();
  const std::vector<Taps> across = taps_of(image.width, width);
  const std::vector<Taps> down = taps_of(image.height, height);

  // Rows first: the result of the narrower pass is what the second one reads.
  const auto narrow = static_cast<std::size_t>(width);
  std::vector<double> rows(3 * narrow * static_cast<std::size_t>(image.height), 0.0);
  for (int y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < narrow; ++x) {
      double* out = &rows[3 * (static_cast<std::size_t>(y) * narrow + x)];
      for (std::size_t k = 0; k < across[x].weights.size(); ++k) {
        const int s = std::clamp(across[x].first + static_cast<int>(k), 0, image.width - 1);
        const std::uint8_t* pixel = image.at(s, y);
        for (int c = 0; c < 3; ++c) out[c] += across[x].weights[k] * linear[pixel[c]];
      }
    }
  }

  Image8 result(width, height);
  for (int y = 0; y < height; ++y) {
    const Taps& taps = down[static_cast<std::size_t>(y)];
    for (std::size_t x = 0; x < narrow; ++x) {
      std::array<double, 3> sum{};
      for (std::size_t k = 0; k < taps.weights.size(); ++k) {
        const int s = std::clamp(taps.first + static_cast<int>(k), 0, image.height - 1);
        const double* row = &rows[3 * (static_cast<std::size_t>(s) * narrow + x)];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += taps.weights[k] * row[c];
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const double encoded = srgb_from_linear(std::clamp(sum[c], 0.0, 1.0));
        result.at(static_cast<int>(x), y)[c] =
            static_cast<std::uint8_t>(std::lround(255.0 * encoded));
      }
    }
  }
  return result;
}

}  // namespace mien::render
