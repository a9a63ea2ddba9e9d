#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/image/image.h"

namespace mien::render {

/// Histogram of the colours of a film: 64 × 64 × 64 cells of the sRGB cube, with the sum of the
/// colours in each.
class ColourHistogram {
 public:
  struct Cell {
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> sum{};  ///< sums of the channels, 0 … 255 per pixel
  };

  ColourHistogram() : cells_(std::size_t{1} << 18) {}

  void add(const Image8& frame);
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  std::vector<Cell> cells_;
};

/// A palette of at most 255 colours that represent those of a film, and a transparent entry for
/// unchanged pixels. Colours are found by splitting along the axis of greatest variance (Wan, Wong
/// and Prusinkiewicz 1988) and improved by Lloyd's iteration.
class ColourTable {
 public:
  explicit ColourTable(const ColourHistogram& histogram);

  /// Writes 256 entries, 0xAARRGGBB.
  void copy_entries(std::uint32_t* entries) const;

  /// Writes the palette index of each pixel of a frame, with ordered dither (Bayer 8 × 8). An
  /// unchanged pixel has the same index in every frame, so static areas do not flicker. The
  /// dither's amplitude is the average spacing of the palette's colours. Rows of `numbers` are
  /// `stride` bytes apart.
  void index(const Image8& frame, std::uint8_t* numbers, int stride);

  int size() const { return static_cast<int>(colours_.size()); }

 private:
  std::uint8_t nearest(int red, int green, int blue);

  std::vector<std::array<double, 3>> colours_;
  std::array<std::array<int, 8>, 8> offsets_{};  ///< offsets of the dither
  std::vector<std::uint8_t> nearest_;            ///< cache by the channels' upper 7 bits
};

}  // namespace mien::render
