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
  bool are_soft = false;                  ///< all half shadows are many pixels wide
  std::vector<std::vector<int>> casters;  ///< of each light, the round cones that may hide it
};

/// Points of the floor that ask how much of the lights round cones hide from them, each on one line
/// across each light (line_shadow.h), gathered and answered eight at a time. What they find is
/// taken from the pixels, which have to stay where they are until `answer`, as has the tile.
class LineQueries {
 public:
  LineQueries(const Picture& picture, const TileLines& tile) : picture_(picture), tile_(tile) {}

  const TileLines& of_tile() const { return tile_; }

  /// For so many samples of a pixel; `index` is that of the random numbers, for sample_point.
  void ask(Pixel& pixel, const Vec3& point, std::uint32_t index, int samples);

  /// Those that are still waiting.
  void answer();

 private:
  void take_hidden(int light);

  const Picture& picture_;
  const TileLines& tile_;
  int count_ = 0;
  std::array<Pixel*, lanes> pixels_{};
  LaneVectors points_;
  LaneWords index_;
  LaneFloats samples_;
  std::array<Color, lanes> taken_;  // a sample
  std::array<std::vector<LinePart>, lanes> hidden_;
};

}  // namespace mien::render
