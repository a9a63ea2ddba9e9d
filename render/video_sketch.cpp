#include "render/video_sketch.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace mien::render {

namespace {

constexpr int most_tiles = 768;
constexpr int least_part = 64;  ///< pixels of a tile at the edge that is looked at by itself

int edge_for(int width, int height) {
  int edge = 16;
  const auto tiles = [&] { return ((width + edge - 1) / edge) * ((height + edge - 1) / edge); };
  while (tiles() > most_tiles) edge += 8;
  return edge;
}

/// SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

std::vector<std::int8_t> random_signs(std::size_t count, std::uint64_t seed) {
  std::vector<std::int8_t> signs(count);
  for (std::size_t i = 0; i < count; ++i) {
    signs[i] = (mixed(seed + i / 64) >> (i % 64)) & 1 ? std::int8_t{1} : std::int8_t{-1};
  }
  return signs;
}

std::uint64_t hash_of(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t hash = bytes.size();
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    hash = (hash ^ word) * 0x9fb21c651e98df25ull;
    hash ^= hash >> 32;
  }
  for (; i < bytes.size(); ++i) hash = mixed(hash ^ bytes[i]);
  return mixed(hash);
}

/// BT.709 luma of sRGB channels, rounded.
void luma_row(const std::uint8_t* rgb, int width, std::uint8_t* luma) {
  for (int x = 0; x < width; ++x) {
    luma[x] = static_cast<std::uint8_t>(
        (54 * rgb[3 * x] + 183 * rgb[3 * x + 1] + 19 * rgb[3 * x + 2] + 128) >> 8);
  }
}

int signed_sum(const std::uint8_t* values, const std::int8_t* signs, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i) sum += signs[i] * values[i];
  return sum;
}

/// Sums over the part of a tile that has been read.
struct Sums {
  std::int64_t luma = 0;
  std::int64_t squares = 0;
  std::int64_t luma_projection = 0;
  std::int64_t color_projection = 0;

  void add(const std::uint8_t* values, int count) {
    std::int32_t sum = 0;
    std::int32_t square_sum = 0;
    for (int i = 0; i < count; ++i) {
      sum += values[i];
      square_sum += values[i] * values[i];
    }
    luma += sum;
    squares += square_sum;
  }

  FrameSketch::Tile tile(int pixels) const {
    const double mean = static_cast<double>(luma) / pixels;
    return {static_cast<float>(mean),
            static_cast<float>(std::max(0.0, static_cast<double>(squares) / pixels - mean * mean)),
            static_cast<float>(luma_projection), static_cast<float>(color_projection)};
  }
};

double squared(double x) { return x * x; }

/// SSIM of a tile, its covariance found from the mean squared difference.
double ssim_of(const FrameSketch::Tile& a, const FrameSketch::Tile& b, int pixels) {
  constexpr double c1 = 0.01 * 255 * 0.01 * 255;
  constexpr double c2 = 0.03 * 255 * 0.03 * 255;
  const double ma = static_cast<double>(a.mean);
  const double mb = static_cast<double>(b.mean);
  const double variances = static_cast<double>(a.variance) + static_cast<double>(b.variance);
  const double square =
      squared(static_cast<double>(a.luma_projection) - static_cast<double>(b.luma_projection)) /
      pixels;
  const double twice_covariance = variances - square + squared(ma - mb);
  return (2.0 * ma * mb + c1) * (twice_covariance + c2) /
         ((ma * ma + mb * mb + c1) * (variances + c2));
}

}  // namespace

FrameSketcher::FrameSketcher(int width, int height)
    : width_(width),
      height_(height),
      edge_(edge_for(width, height)),
      across_((width + edge_ - 1) / edge_),
      down_((height + edge_ - 1) / edge_),
      color_signs_(random_signs(
          static_cast<std::size_t>(3 * width) * static_cast<std::size_t>(edge_), 1ull << 40)),
      luma_signs_(random_signs(static_cast<std::size_t>(width) * static_cast<std::size_t>(edge_),
                               2ull << 40)) {}

FrameSketch FrameSketcher::sketch(const Image8& frame) const {
  if (frame.width != width_ || frame.height != height_) {
    throw std::invalid_argument("FrameSketcher: a frame of another size");
  }
  FrameSketch result;
  result.hash = hash_of(frame.channels);
  result.tiles.reserve(static_cast<std::size_t>(tile_count()));
  std::vector<std::uint8_t> luma(static_cast<std::size_t>(width_));
  for (int top = 0; top < height_; top += edge_) {
    const int rows = std::min(edge_, height_ - top);
    std::vector<Sums> sums(static_cast<std::size_t>(across_));
    for (int row = 0; row < rows; ++row) {
      const std::uint8_t* rgb = frame.at(0, top + row);
      const std::int8_t* color_signs =
          color_signs_.data() + static_cast<std::ptrdiff_t>(row) * 3 * width_;
      const std::int8_t* luma_signs =
          luma_signs_.data() + static_cast<std::ptrdiff_t>(row) * width_;
      luma_row(rgb, width_, luma.data());
      for (int i = 0; i < across_; ++i) {
        const int left = i * edge_;
        const int columns = std::min(edge_, width_ - left);
        Sums& tile = sums[static_cast<std::size_t>(i)];
        tile.add(luma.data() + left, columns);
        tile.luma_projection += signed_sum(luma.data() + left, luma_signs + left, columns);
        tile.color_projection += signed_sum(rgb + 3 * left, color_signs + 3 * left, 3 * columns);
      }
    }
    for (int i = 0; i < across_; ++i) {
      const int columns = std::min(edge_, width_ - i * edge_);
      result.tiles.push_back(sums[static_cast<std::size_t>(i)].tile(rows * columns));
    }
  }
  return result;
}

Likeness FrameSketcher::likeness(const FrameSketch& a, const FrameSketch& b) const {
  if (a.hash == b.hash) return {true, std::numeric_limits<double>::infinity(), 1.0, 0.0};
  double worst_part = 0.0;
  double square = 0.0;
  double ssim = 0.0;
  for (int i = 0; i < tile_count(); ++i) {
    const FrameSketch::Tile& ta = a.tiles[static_cast<std::size_t>(i)];
    const FrameSketch::Tile& tb = b.tiles[static_cast<std::size_t>(i)];
    square += squared(static_cast<double>(ta.color_projection) -
                      static_cast<double>(tb.color_projection));
    const int columns = std::min(edge_, width_ - i % across_ * edge_);
    const int rows = std::min(edge_, height_ - i / across_ * edge_);
    if (columns * rows >= least_part) {
      worst_part = std::max(worst_part,
                            std::abs(static_cast<double>(ta.mean) - static_cast<double>(tb.mean)));
    }
    ssim += columns * rows * ssim_of(ta, tb, columns * rows);
  }
  const double pixels = static_cast<double>(width_) * height_;
  // Not identical, so there is at least one difference of one.
  const double mean_square = std::max(square, 1.0) / (3.0 * pixels);
  return {false, 10.0 * std::log10(255.0 * 255.0 / mean_square), std::min(1.0, ssim / pixels),
          worst_part};
}

}  // namespace mien::render
