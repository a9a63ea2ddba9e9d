#pragma once

#include "render/compare/pixel_map.h"
#include "render/image/image.h"

namespace mien::render {

/// SSIM of two pictures (Wang, Bovik, Sheikh and Simoncelli 2004) on BT.709 luma of their sRGB
/// codes: windows of 11 × 11 pixels weighted by a Gaussian of standard deviation 1.5 pixels, K1 =
/// 0.01, K2 = 0.03, L = 255. It is symmetric, 1 for equal pictures and never below −1.
struct StructuralSimilarity {
  PixelMap map;  ///< SSIM of the window around each pixel; border pixels are replicated

  /// Mean over the windows that lie entirely within the picture, as in the paper; over all windows
  /// if there are none.
  double mean = 1.0;
};

/// Throws Error when sizes differ or are 0.
StructuralSimilarity structural_similarity(const Image8& a, const Image8& b);

}  // namespace mien::render
