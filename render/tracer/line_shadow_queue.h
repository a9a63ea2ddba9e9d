#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/light/line_shadow.h"
#include "render/tracer/pixel.h"
#include "render/tracer/prepared_scene.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// Line shadows (line_shadow.h) on the floor of a tile.
struct TileLineShadows {
  std::uint32_t lights = 0;  ///< bit i: light i is line-sampled
  float penumbra = 0.0f;     ///< width of the narrowest penumbra, pixels
  /// Per light: indices of the round cones that may occlude it.
  std::vector<std::vector<int>> casters;
};

/// How many samples share a line: some of one pixel, or all of several neighbouring pixels.
struct SharedLine {
  int samples;  ///< of all these pixels together
  int pixels;
};

/// Penumbrae at least 4 pixels wide vary so little within a pixel that four of its samples share a
/// line. With two samples per pixel, the four samples of two pixels share a line in penumbrae at
/// least 8 pixels wide, and the eight samples of 2 × 2 pixels in those at least 16 pixels wide.
/// With one sample per pixel, two pixels share a line in narrow penumbrae and up to 4 × 4 in wide
/// ones.
SharedLine shared_line(const TileLineShadows& tile, int samples_per_pixel);

/// A block of pixels that share a line, aligned to multiples of its size: a power of two of
/// consecutive pixels on the Morton curve.
struct PixelBlock {
  int width;
  int height;
};
PixelBlock block_of(const SharedLine& shared);

/// The blocks of a tile whose pixels share a line, with the result for each.
class FloorBlocks {
 public:
  /// Resets to blocks of this size, none requested.
  void clear(const PixelBlock& size);

  /// Requests the occlusion of these lights for the block of a pixel.
  void add(int x, int y, std::uint32_t lights) { blocks_[number(x, y)].lights |= lights; }

  /// Occluded irradiance, divided by π, of each sample of a pixel whose block was requested.
  const Color& occluded(int x, int y) const { return blocks_[number(x, y)].occluded; }

  const PixelBlock& size() const { return size_; }

 private:
  friend class LineShadowQueue;
  struct Block {
    std::uint32_t lights;
    Color occluded;
  };

  std::size_t number(int x, int y) const {
    return static_cast<std::size_t>((y % tile_size / size_.height) * across_ +
                                    x % tile_size / size_.width);
  }

  PixelBlock size_{1, 1};
  int across_ = tile_size;
  int count_ = 0;
  std::array<Block, static_cast<std::size_t>(tile_size* tile_size / 2)> blocks_;
};

/// Samples of the floor whose shadows are computed by line sampling, one line across each light
/// (line_shadow.h), collected and resolved eight at a time. The occluded light is subtracted from
/// the pixels, which, like the tile, must not move before `resolve`.
class LineShadowQueue {
 public:
  LineShadowQueue(const PreparedScene& prepared, const TileLineShadows& tile)
      : prepared_(prepared), tile_(tile) {}

  const TileLineShadows& of_tile() const { return tile_; }

  /// Queues the line of `sample`, on behalf of the `samples` samples of the pixel that share it.
  /// Where several pixels share a line, this only counts the samples; the line of their block is
  /// queued later.
  void enqueue(FloorPixel& pixel, int sample, int samples);

  /// Queues the lines of all samples of a pixel.
  void enqueue_all(FloorPixel& pixel);

  /// Queues the lines of the requested blocks of a tile.
  void enqueue_all(const Tile& tile, FloorBlocks& blocks);

  /// Resolves the lines that are still queued.
  void resolve();

 private:
  struct Query {
    int x = 0;  // position of the pixel, or of one of those that share the line
    int y = 0;
    std::uint32_t lights = 0;     // lights that may be occluded
    int group = 0;                // index of the group of the pixel's samples
    int samples = 0;              // number of the pixel's samples that share the line
    FloorPixel* pixel = nullptr;  // receives the result; null: `block` does
    Color* block = nullptr;       // receives the result of a block
  };

  void add(const Query& query);
  void choose_lines(const SharedLine& shared);
  void add_hidden(int light);

  const PreparedScene& prepared_;
  const TileLineShadows& tile_;
  std::array<Query, lanes> queries_;
  int count_ = 0;
  LaneVectors points_;  // points of the floor
  LaneWords index_;     // indices of the random numbers
  LaneFloats across_;   // position on the first light, in [0, 1)
  std::array<bool, lanes> meets_floor_{};
  std::array<Color, lanes> occluded_;  // per sample
  std::array<std::vector<LineInterval>, lanes> hidden_;
};

}  // namespace mien::render
