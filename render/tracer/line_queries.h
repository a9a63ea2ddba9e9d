#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/light/line_shadow.h"
#include "render/tracer/picture.h"
#include "render/tracer/pixel.h"
#include "render/tracer/tile.h"

namespace mien::render {

/// What lines of the lights are asked for on the floor of a tile.
struct TileLines {
  std::uint32_t lights = 0;               ///< bit i: of light i
  float half_shadow = 0.0f;               ///< how wide half shadows are at least, pixels
  std::vector<std::vector<int>> casters;  ///< of each light, the round cones that may hide it
};

/// Samples that share a line: of a pixel, or all those of neighbours.
struct SharedLine {
  int samples;
  int pixels;
};

/// Where half shadows are wide they change so little within a pixel that four samples share the
/// line of one; where they are twice as wide, also four samples of two pixels, and where four
/// times, eight of 2 × 2. Where pixels have one sample, 2 to 4 × 4 of them share one.
SharedLine shared_line(const TileLines& tile, int samples_per_pixel);

/// Pixels that share a line are side by side, and begin at multiples of these: of a power of two,
/// those that follow each other on the Morton curve.
struct PixelBlock {
  int width;
  int height;
};
PixelBlock block_of(const SharedLine& shared);

/// The blocks of a tile whose pixels share a line, and what that finds.
class FloorBlocks {
 public:
  /// No pixel of them asks.
  void clear(const PixelBlock& size);

  /// A pixel of the film asks what may hide these lights from its floor.
  void add(int x, int y, std::uint32_t lights) { blocks_[number(x, y)].lights |= lights; }

  /// What is taken of the irradiance over π of each sample of a pixel that asked.
  const Color& taken(int x, int y) const { return blocks_[number(x, y)].taken; }

  const PixelBlock& size() const { return size_; }

 private:
  friend class LineQueries;
  struct Block {
    std::uint32_t lights;
    Color taken;
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

/// Samples that show the floor ask how much of the lights round cones hide from it, each on one
/// line across each light (line_shadow.h), gathered and answered eight at a time. What they find is
/// taken from the pixels, which have to stay where they are until `answer`, as has the tile.
class LineQueries {
 public:
  LineQueries(const Picture& picture, const TileLines& tile) : picture_(picture), tile_(tile) {}

  const TileLines& of_tile() const { return tile_; }

  /// For so many samples of a pixel that share a line, the one that `sample` has. Where pixels
  /// share lines their block asks, and they are told later.
  void ask(FloorPixel& pixel, int sample, int samples);

  /// For all samples of a pixel.
  void ask_all(FloorPixel& pixel);

  /// For the blocks of a tile, of which pixels asked.
  void ask_all(const Tile& tile, FloorBlocks& blocks);

  /// Answers those that are still waiting.
  void answer();

 private:
  struct Query {
    int x = 0;  // of the pixel, or of one of those that share the line
    int y = 0;
    std::uint32_t lights = 0;     // that may be hidden
    int group = 0;                // of the pixel's samples
    int samples = 0;              // of the pixel
    FloorPixel* pixel = nullptr;  // takes the answer,
    Color* block = nullptr;       // or this
  };

  void add(const Query& query);
  void aim(const SharedLine& shared);
  void take_hidden(int light);

  const Picture& picture_;
  const TileLines& tile_;
  std::array<Query, lanes> queries_;
  int count_ = 0;
  LaneVectors points_;  // of the floor
  LaneWords index_;     // of random numbers
  LaneFloats across_;   // where on the first light, in [0, 1)
  std::array<bool, lanes> meets_floor_{};
  std::array<Color, lanes> taken_;  // a sample
  std::array<std::vector<LinePart>, lanes> hidden_;
};

}  // namespace mien::render
