#pragma once

#include <string>
#include <vector>

#include "pipeline/regression/comparison/body_shares.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "render/compare/perceptual_error.h"
#include "render/compare/picture_difference.h"

namespace mien::pipeline {

/// The size of a picture, in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};

/// The comparison of a frame with its former state.
struct FrameComparison {
  int frame = 0;  ///< index of the former frame; it is compared with the corresponding current one
  std::string name = {};  ///< name of the file of the former frame; empty for a video
  bool same = true;       ///< every pixel is equal
  bool same_size = true;  ///< false: only the sizes below are set
  PictureSize size_before, size_now;
  render::PictureDifference difference;
  /// Measures of the same pictures by OpenImageIO.
  render::LibraryDifference openimageio_difference;
  render::ErrorSummary perceived;  ///< ꟻLIP error, 0 … 1
  render::PixelMap perceived_map;  ///< ꟻLIP error per pixel; empty once it is saved
  double similarity = 1.0;         ///< SSIM
  NoiseTest noise;
  std::vector<BodyShare> shares;  ///< set if the motion has changed
};

/// Returns everything except `name`, `noise` and `shares`. If the pictures are equal, the measures
/// keep their defaults. `threads` 0: one per core.
FrameComparison compare_pictures(int frame, const render::Image8& before, const render::Image8& now,
                                 int threads = 0);

}  // namespace mien::pipeline
