#include "render/video/video_sketch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <xxhash.h>

#include "render/math/for_avx2.h"

namespace mien::render {

namespace {

constexpr int most_tiles = 512;
constexpr double mean_steps = 256.0;
constexpr double deviation_steps = 512.0;
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

/// BT.709 luma of sRGB channels, rounded.
MIEN_FOR_AVX2_TOO void luma_row(const std::uint8_t* rgb, int width, std::uint8_t* luma) {
  for (int x = 0; x < width; ++x) {
    luma[x] = static_cast<std::uint8_t>(
        (54 * rgb[3 * x] + 183 * rgb[3 * x + 1] + 19 * rgb[3 * x + 2] + 128) >> 8);
  }
}

/// Sums over a part of a tile.
struct Sums {
  std::int64_t luma = 0;
  std::int64_t squares = 0;
  std::int64_t luma_projection = 0;
  std::int64_t color_projection = 0;

  void add(const Sums& other) {
    luma += other.luma;
    squares += other.squares;
    luma_projection += other.luma_projection;
    color_projection += other.color_projection;
  }

  FrameSketch::Tile tile(int pixels) const {
    const double mean = static_cast<double>(luma) / pixels;
    const double variance = std::max(0.0, static_cast<double>(squares) / pixels - mean * mean);
    const auto scaled = [](std::int64_t projection, int values) {
      return Eigen::half(static_cast<float>(static_cast<double>(projection) / std::sqrt(values)));
    };
    return {static_cast<std::uint16_t>(std::lround(mean_steps * mean)),
            static_cast<std::uint16_t>(std::lround(deviation_steps * std::sqrt(variance))),
            scaled(luma_projection, pixels), scaled(color_projection, 3 * pixels)};
  }
};

/// Sums over a tile's pixels in one row; three colours and signs a pixel.
MIEN_FOR_AVX2_TOO Sums sums_of(const std::uint8_t* luma, const std::int8_t* luma_signs,
                               const std::uint8_t* colors, const std::int8_t* color_signs,
                               int pixels) {
  std::int32_t sum = 0, squares = 0, luma_projection = 0, color_projection = 0;
  for (int i = 0; i < pixels; ++i) {
    const std::int16_t value = luma[i];
    sum += value;
    squares += value * value;
    luma_projection += value * std::int16_t{luma_signs[i]};
  }
  for (int i = 0; i < 3 * pixels; ++i)
    color_projection += std::int16_t{colors[i]} * std::int16_t{color_signs[i]};
  return {sum, squares, luma_projection, color_projection};
}

std::uint64_t hash_of_rows(const std::uint8_t* row, std::ptrdiff_t row_bytes, std::size_t bytes,
                           int rows) {
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              XXH3_freeState);
  XXH3_64bits_reset(state.get());
  for (int y = 0; y < rows; ++y, row += row_bytes) XXH3_64bits_update(state.get(), row, bytes);
  return XXH3_64bits_digest(state.get());
}

double squared(double x) { return x * x; }

double mean_of(const FrameSketch::Tile& tile) { return tile.mean / mean_steps; }
double variance_of(const FrameSketch::Tile& tile) {
  return squared(tile.deviation / deviation_steps);
}

/// Mean square of the difference, in the mean over all signs.
double square_between(Eigen::half a, Eigen::half b) {
  return squared(static_cast<double>(static_cast<float>(a)) -
                 static_cast<double>(static_cast<float>(b)));
}

/// SSIM of a tile, its covariance found from the mean squared difference.
double ssim_of(const FrameSketch::Tile& a, const FrameSketch::Tile& b) {
  constexpr double c1 = 0.01 * 255 * 0.01 * 255;
  constexpr double c2 = 0.03 * 255 * 0.03 * 255;
  const double ma = mean_of(a), mb = mean_of(b);
  const double variances = variance_of(a) + variance_of(b);
  const double square = square_between(a.luma_projection, b.luma_projection);
  const double twice_covariance = variances - square + squared(ma - mb);
  return (2.0 * ma * mb + c1) * (twice_covariance + c2) /
         ((ma * ma + mb * mb + c1) * (variances + c2));
}

}  // namespace

FrameSketcher::FrameSketcher(int width, int height, int row_step)
    : width_(width),
      height_((height + row_step - 1) / row_step),
      whole_height_(height),
      row_step_(row_step),
      edge_(edge_for(width, height_)),
      across_((width + edge_ - 1) / edge_),
      down_((height_ + edge_ - 1) / edge_),
      color_signs_(random_signs(
          static_cast<std::size_t>(3 * width) * static_cast<std::size_t>(edge_), 1ull << 40)),
      luma_signs_(random_signs(static_cast<std::size_t>(width) * static_cast<std::size_t>(edge_),
                               2ull << 40)) {}

FrameSketch FrameSketcher::sketch(const Image8& frame) const {
  if (frame.width != width_ || frame.height != whole_height_) {
    throw std::invalid_argument("FrameSketcher: a frame of a different size");
  }
  return sketch_from(frame.channels.data(), std::ptrdiff_t{3} * row_step_ * width_);
}

FrameSketch FrameSketcher::sketch_of_rows(const Image8& rows) const {
  if (rows.width != width_ || rows.height != height_) {
    throw std::invalid_argument("FrameSketcher: rows of a different size");
  }
  return sketch_from(rows.channels.data(), std::ptrdiff_t{3} * width_);
}

FrameSketch FrameSketcher::sketch_from(const std::uint8_t* rows_begin,
                                       std::ptrdiff_t row_bytes) const {
  FrameSketch result;
  result.hash = hash_of_rows(rows_begin, row_bytes, static_cast<std::size_t>(3 * width_), height_);
  result.tiles.reserve(static_cast<std::size_t>(tile_count()));
  std::vector<std::uint8_t> luma(static_cast<std::size_t>(width_));
  for (int top = 0; top < height_; top += edge_) {
    const int rows = std::min(edge_, height_ - top);
    std::vector<Sums> sums(static_cast<std::size_t>(across_));
    for (int row = 0; row < rows; ++row) {
      const std::uint8_t* rgb = rows_begin + (top + row) * row_bytes;
      const std::int8_t* color_signs =
          color_signs_.data() + static_cast<std::ptrdiff_t>(row) * 3 * width_;
      const std::int8_t* luma_signs =
          luma_signs_.data() + static_cast<std::ptrdiff_t>(row) * width_;
      luma_row(rgb, width_, luma.data());
      for (int i = 0; i < across_; ++i) {
        const int left = i * edge_;
        const int columns = std::min(edge_, width_ - left);
        sums[static_cast<std::size_t>(i)].add(sums_of(luma.data() + left, luma_signs + left,
                                                      rgb + 3 * left, color_signs + 3 * left,
                                                      columns));
      }
    }
    for (int i = 0; i < across_; ++i) {
      const int columns = std::min(edge_, width_ - i * edge_);
      result.tiles.push_back(sums[static_cast<std::size_t>(i)].tile(rows * columns));
    }
  }
  return result;
}

FrameSimilarity FrameSketcher::similarity(const FrameSketch& a, const FrameSketch& b) const {
  if (a.hash == b.hash) return {true, std::numeric_limits<double>::infinity(), 1.0, 0.0, 0.0};
  double worst_part = 0.0;
  double parts_square = 0.0;
  double square = 0.0;
  double ssim = 0.0;
  for (int i = 0; i < tile_count(); ++i) {
    const FrameSketch::Tile& ta = a.tiles[static_cast<std::size_t>(i)];
    const FrameSketch::Tile& tb = b.tiles[static_cast<std::size_t>(i)];
    const int columns = std::min(edge_, width_ - i % across_ * edge_);
    const int rows = std::min(edge_, height_ - i / across_ * edge_);
    const int in_tile = columns * rows;
    square += in_tile * square_between(ta.color_projection, tb.color_projection);
    if (in_tile >= least_part) {
      const double part = std::abs(mean_of(ta) - mean_of(tb));
      worst_part = std::max(worst_part, part);
      parts_square += part * part;
    }
    ssim += in_tile * ssim_of(ta, tb);
  }
  const double pixels = static_cast<double>(width_) * height_;
  // Not identical, so there is at least one difference of one.
  const double mean_square = std::max(square / pixels, 1.0 / (3.0 * pixels));
  return {false, 10.0 * std::log10(255.0 * 255.0 / mean_square), std::min(1.0, ssim / pixels),
          worst_part, parts_square};
}

}  // namespace mien::render
