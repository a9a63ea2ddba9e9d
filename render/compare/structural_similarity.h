#pragma once

#include "render/compare/pixel_map.h"
#include "render/image/image.h"

namespace mien::render {

/// SSIM of two pictures (Wang, Bovik, Sheikh and Simoncelli 2004) on BT.709 luma of their sRGB
/// codes: windows of 11 × 11 pixels under a Gaussian of standard deviation 1.5, K1 = 0.01,
/// K2 = 0.03, L = 255. 1 for equal pictures, −1 at least; symmetric.
struct StructuralSimilarity {
  PixelMap map;  ///< of the window about each pixel; beyond the border its pixels go on

  /// Over the windows that lie wholly in the picture, as its authors have it; over all where the
  /// picture holds none.
  double mean = 1.0;
};

/// Throws Error when sizes differ.
StructuralSimilarity structural_similarity(const Image8& a, const Image8& b);

}  // namespace mien::render
