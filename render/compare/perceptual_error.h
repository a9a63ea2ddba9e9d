#pragma once

#include "render/compare/pixel_map.h"
#include "render/image/image.h"

namespace mien::render {

/// Viewing conditions of a picture, by default those of the paper: a screen 3,840 pixels and 0.7 m
/// wide, seen from 0.7 m, which is 67.02 pixels per degree of visual angle.
struct Viewing {
  double distance_metres = 0.7;  ///< from the eye to the screen, metres
  double screen_metres = 0.7;    ///< width of the screen, metres
  int screen_pixels = 3840;      ///< width of the screen, pixels

  double pixels_per_degree() const;
};

/// Returns the ꟻLIP error of each pixel: the difference that a viewer perceives when flipping
/// between the two displayed pictures, 0 (none) … 1. It is symmetric, 0 for equal pictures, and
/// bit-identical on every machine and for any number of threads.
///
/// After Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A
/// Difference Evaluator for Alternating Images", the variant for low dynamic range: filters, colour
/// distance, its redistribution, feature detection and their combination follow the paper. Where
/// the paper leaves a choice, this follows the authors' implementation: border pixels are
/// replicated, filters are cut off at three standard deviations of the widest Gaussian, and the
/// white is D65 at chromaticity (0.31271, 0.32902). Errors are not quantised. With `threads` 0, one
/// thread per core is used.
///
/// It has not been compared with published values, because the pictures that they belong to were
/// not available. The tests compare it with an independent implementation of the formulas, in two
/// dimensions and in double precision.
///
/// Throws Error when sizes differ or are 0, std::invalid_argument when the viewing conditions do
/// not result in 1 to 1,000 pixels per degree.
PixelMap perceptual_error(const Image8& a, const Image8& b, const Viewing& viewing = {},
                          int threads = 0);

/// Statistics of a map of errors, which are 0 … 1; all 0 for an empty map.
struct ErrorSummary {
  double mean = 0.0;
  double least = 0.0;
  double largest = 0.0;
  int largest_x = 0;  ///< position of the largest error: the first in row-major order
  int largest_y = 0;

  /// Quartiles weighted by error, so that many error-free pixels do not hide the few others: the
  /// errors up to which a quarter, half and three quarters of the sum of all errors lie. Resolution
  /// 1/65,536.
  double weighted_first_quartile = 0.0;
  double weighted_median = 0.0;
  double weighted_third_quartile = 0.0;
};
ErrorSummary summary_of(const PixelMap& errors);

}  // namespace mien::render
