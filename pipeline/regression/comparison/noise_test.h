#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "render/image/framebuffer.h"

namespace mien::pipeline {

/// Width and height of a block in pixels. Blocks at the right and lower edges may be smaller.
inline constexpr int block_pixels = 8;

/// Number of pictures with independent noise patterns from which block statistics are computed.
inline constexpr int noise_patterns = 8;

/// Mean light of a picture's blocks and its variance between noise patterns, in linear values: red,
/// green and blue of each block, row by row.
struct BlockStatistics {
  int columns = 0;
  int rows = 0;
  int patterns = 0;             ///< number of pictures measured
  std::vector<float> mean;      ///< mean over all patterns
  std::vector<float> variance;  ///< variance of a block's mean between patterns (n − 1)

  std::size_t count() const { return mean.size(); }
};

/// The block statistics of at least two pictures of one scene that differ only in their noise.
BlockStatistics block_statistics(const std::vector<render::Framebuffer>& patterns);

/// Write and read block statistics as an EXR file: one pixel per block with the means, and below
/// these, one per block with the variances. `patterns` is not stored; reading sets it to
/// noise_patterns. Both throw render::Error; reading throws std::runtime_error if the file does not
/// contain block statistics.
void write_blocks(const std::filesystem::path& file, const BlockStatistics& blocks);
BlockStatistics read_blocks(const std::filesystem::path& file);

/// The result of testing whether two pictures differ by more than their noise.
struct NoiseTest {
  std::size_t tests = 0;    ///< one for each colour of a block that has noise or a difference
  std::size_t outside = 0;  ///< number of tests that show a difference individually
  /// Welch's t with the largest absolute value; positive if the current picture is brighter.
  double largest_t = 0.0;
  double least_p = 1.0;  ///< smallest p value of a test, without correction
  /// P value of all blocks together, which detects a faint difference everywhere.
  double together_p = 1.0;
  double largest_bias = 0.0;  ///< largest difference of a differing block, relative to its light
  bool is_bias = false;       ///< the pictures differ by more than noise

  friend bool operator==(const NoiseTest&, const NoiseTest&) = default;
};

/// Probability that a suite without any change has a picture that is reported as changed.
inline constexpr double suite_false_alarms = 0.001;

/// Tests each block and colour with Welch's t (1947), corrected for their number (Šidák), and all
/// blocks together with χ² of the t values as normal scores. Both tests are corrected for the
/// number of `pictures` in a suite (Bonferroni). Each of the two tests is allowed half of the false
/// alarms. The colours of a block share their noise, so χ² uses their mean. Differences below 1e-4
/// times the light, or below the linear value 1e-5, are treated as zero, because rounding causes
/// them. Throws Error if the pictures differ in size.
NoiseTest noise_test(const BlockStatistics& before, const BlockStatistics& now,
                     std::size_t pictures, double false_alarms = suite_false_alarms);

}  // namespace mien::pipeline
