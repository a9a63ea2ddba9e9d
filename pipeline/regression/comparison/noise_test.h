#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "render/image/framebuffer.h"

namespace mien::pipeline {

/// Pixels to a side of a block. Those at the right and lower edge may be smaller.
inline constexpr int block_pixels = 8;

/// Pictures with noise patterns of their own that blocks are measured from.
inline constexpr int noise_patterns = 8;

/// Mean light of a picture's blocks, and how far it goes from one noise pattern to another. Linear:
/// red, green and blue of the first block, then of the next, row by row.
struct BlockStatistics {
  int columns = 0;
  int rows = 0;
  int patterns = 0;             ///< pictures that were measured
  std::vector<float> mean;      ///< of all patterns
  std::vector<float> variance;  ///< of a block's mean in one of them (n − 1)

  std::size_t count() const { return mean.size(); }
};

/// The block statistics of at least two pictures of one scene that differ only in their noise.
BlockStatistics block_statistics(const std::vector<render::Framebuffer>& patterns);

/// Keeps them as an EXR file, a pixel a block. Both throw render::Error, and reading
/// std::runtime_error when the file holds no such statistics.
void write_blocks(const std::filesystem::path& file, const BlockStatistics& blocks);
BlockStatistics read_blocks(const std::filesystem::path& file);

/// Whether two pictures differ by more than their noise.
struct NoiseTest {
  std::size_t tests = 0;      ///< blocks and colours in which there is noise, or a difference
  std::size_t outside = 0;    ///< that differ, each for itself
  double largest_t = 0.0;     ///< of Welch's t, by its size
  double least_p = 1.0;       ///< of one block, not yet corrected
  double together_p = 1.0;    ///< of all: a faint difference everywhere
  double largest_bias = 0.0;  ///< of a block that differs, relative to its light
  bool is_bias = false;       ///< differs by more than noise

  friend bool operator==(const NoiseTest&, const NoiseTest&) = default;
};

/// Share of suites without any change in which some picture is taken for changed.
inline constexpr double suite_false_alarms = 0.001;

/// Welch's t (1947) of each block and colour, corrected over all of them and over all `pictures` of
/// a suite (Šidák), and χ² of all blocks' t as normal scores; half of the false alarms are the one
/// test's and half the other's. Colours of a block share their noise, so χ² has their mean. A
/// difference of less than a ten-thousandth of the light, or of 1e-5, is what arithmetic in another
/// order makes, and counts as none. Throws Error when the pictures differ in size.
NoiseTest noise_test(const BlockStatistics& before, const BlockStatistics& now,
                     std::size_t pictures, double false_alarms = suite_false_alarms);

}  // namespace mien::pipeline
