#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "render/image/image.h"
#include "render/video/video_receipt.h"

namespace mien::render {

/// A summary of a frame, about 4 KB, for comparison with the decoded frame. With it no frame has to
/// be kept or rendered again; the sketches of ten thousand frames take about 40 MB.
struct FrameSketch {
  /// Statistics of one tile (FrameSketcher::tile_edge). Projections are sums of its values with
  /// fixed random signs: the square of the difference of two frames' projections has, over random
  /// signs, the sum of squares of their differences as its expectation (Alon, Matias and Szegedy
  /// 1996). Projections are divided by the square root of the number of values.
  struct Tile {
    std::uint16_t mean = 0;          ///< mean luma, in 256ths of a code value
    std::uint16_t deviation = 0;     ///< standard deviation of luma, in 512ths of a code value
    Eigen::half luma_projection{};   ///< projection of luma
    Eigen::half color_projection{};  ///< projection of all three channels
  };

  std::uint64_t hash = 0;  ///< hash of all channels of the frame's sampled rows
  std::vector<Tile> tiles;
};

/// Similarity of two frames.
struct FrameSimilarity {
  bool identical = false;     ///< whether the hashes are equal
  double psnr_db = 0.0;       ///< over the three channels of 8 bits; infinite when identical
  double ssim = 0.0;          ///< of luma (Wang et al. 2004), uniform windows without overlap
  double worst_part = 0.0;    ///< largest difference of a tile's mean luma, 0 … 255;
                              ///< resolution 1/256; without tiles below 64 pixels
  double parts_square = 0.0;  ///< sum over these tiles of the squares of their differences
};

/// Makes and compares sketches of frames of one size.
///
/// All statements hold for the sampled rows. `identical` is exact except with probability 2⁻⁶⁴.
/// SSIM and the mean squared error from which PSNR follows are unbiased estimates to which every
/// pixel contributes, except for the rounding of projections, which is noticeable above 60 dB. With
/// n tiles the relative standard error of the mean squared error is at most √(2/n) where errors are
/// spread evenly: at most 0.35 dB for the 300 to 512 tiles of usual frames. An error confined to
/// one part shows in `worst_part`.
class FrameSketcher {
 public:
  /// With a `row_step` above 1, only the rows 0, row_step, 2 · row_step … are sampled.
  FrameSketcher(int width, int height, int row_step = 1);

  /// Throws std::invalid_argument for a frame of another size.
  FrameSketch sketch(const Image8& frame) const;

  /// As `sketch`, for a picture that consists of the sampled rows only.
  FrameSketch sketch_of_rows(const Image8& rows) const;

  int row_step() const { return row_step_; }

  FrameSimilarity similarity(const FrameSketch& a, const FrameSketch& b) const;

  /// Edge of a tile, which is also a window of SSIM: pixels across, and as many sampled rows down;
  /// tiles at the right and lower border may be smaller.
  int tile_edge() const { return edge_; }
  int tile_count() const { return across_ * down_; }

 private:
  FrameSketch sketch_from(const std::uint8_t* rows, std::ptrdiff_t row_bytes) const;

  int width_;
  int height_;  // sampled rows
  int whole_height_;
  int row_step_;
  int edge_;
  int across_;
  int down_;
  std::vector<std::int8_t> color_signs_;  ///< signs for one row of tiles: edge × 3 · width
  std::vector<std::int8_t> luma_signs_;   ///< edge × width
};

/// Sketches of all frames of a film, collected while it is written.
struct VideoSketch {
  FrameSketcher sketcher;
  std::vector<FrameSketch> frames;
  std::vector<std::uint64_t> hashes;  ///< hash_of each whole frame

  VideoSketch(int width, int height, int row_step = 1) : sketcher(width, height, row_step) {}
  void add(const Image8& frame) {
    frames.push_back(sketcher.sketch(frame));
    hashes.push_back(hash_of(frame));
  }
};

}  // namespace mien::render
