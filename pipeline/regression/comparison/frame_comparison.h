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

/// A frame before and now.
struct FrameComparison {
  int frame = 0;          ///< its number before; now the same moment
  std::string name = {};  ///< of its file before; empty where it is of a video
  bool same = true;       ///< every pixel
  bool same_size = true;  ///< else nothing below is known but the sizes
  PictureSize size_before, size_now;
  render::PictureDifference difference;
  render::LibraryDifference
      openimageio_difference;      ///< OpenImageIO's measures of the same pictures
  render::ErrorSummary perceived;  ///< ꟻLIP, 0 … 1
  render::PixelMap perceived_map;  ///< empty once it is saved
  double similarity = 1.0;         ///< SSIM
  NoiseTest noise;
  std::vector<BodyShare> shares;  ///< when the motion has changed
};

/// All but `noise` and `shares`. `threads` 0 takes one a core.
FrameComparison compare_pictures(int frame, const render::Image8& before, const render::Image8& now,
                                 int threads = 0);

}  // namespace mien::pipeline
