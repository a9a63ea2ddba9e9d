#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/light/line_shadow.h"
#include "render/tracer/picture.h"
#include "render/tracer/pixel.h"

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
/// line of one; where they are twice as wide, also four samples of up to 2 × 2 pixels.
SharedLine shared_line(const TileLines& tile, int samples_per_pixel);

/// Samples that show the floor ask how much of the lights round cones hide from it, each on one
/// line across each light (line_shadow.h), gathered and answered eight at a time. What they find is
/// taken from the pixels, which have to stay where they are until `answer`, as has the tile.
class LineQueries {
 public:
  LineQueries(const Picture& picture, const TileLines& tile) : picture_(picture), tile_(tile) {}

  const TileLines& of_tile() const { return tile_; }

  /// For so many samples of a pixel that share a line, the one that `sample` has.
  void ask(Pixel& pixel, int sample, int samples);

  /// Whether no more is to be known of a pixel than what lines tell.
  bool tell_all(const Pixel& pixel) const {
    return pixel.kind == PixelKind::floor && pixel.floor_sky_rays == 0 &&
           (pixel.shadow_lights & ~tile_.lights) == 0;
  }

  /// For all samples of a tile's pixels of which lines tell all.
  void ask_all(std::vector<Pixel>& pixels);

  /// Answers those that are still waiting.
  void answer();

 private:
  struct Query {
    std::array<Pixel*, 4> pixels{};
    int count = 0;    // of pixels
    int group = 0;    // of a pixel's samples
    int samples = 0;  // of each pixel
  };

  void add(const Query& query);
  void aim(const SharedLine& shared);
  std::uint32_t shadow_lights(const Query& query) const;
  void take_hidden(int light);

  const Picture& picture_;
  const TileLines& tile_;
  std::array<Query, lanes> queries_;
  int count_ = 0;
  LaneVectors points_;  // of the floor
  LaneWords index_;     // of random numbers
  std::array<bool, lanes> meets_floor_{};
  std::array<Color, lanes> taken_;  // a sample
  std::array<std::vector<LinePart>, lanes> hidden_;
};

}  // namespace mien::render
