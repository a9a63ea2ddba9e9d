#pragma once

#include "render/compare/pixel_map.h"
#include "render/image/image.h"

namespace mien::render {

/// Viewing conditions of a picture, by default those of the paper: a screen of 3,840 pixels and 0.7
/// m, at 0.7 m, which makes 67.02 pixels a degree.
struct Viewing {
  double distance_metres = 0.7;  ///< from the eye to the screen
  double screen_metres = 0.7;    ///< width of the screen
  int screen_pixels = 3840;      ///< across

  double pixels_per_degree() const;
};

/// ꟻLIP of two pictures as a display shows them: what a viewer who flips between them sees of their
/// difference, 0 (nothing) … 1, a pixel each. It is symmetric, 0 for equal pictures, and the same
/// to the bit whatever the threads and the machine.
///
/// After Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A
/// Difference Evaluator for Alternating Images", the variant for low dynamic range: filters, colour
/// distance, its redistribution, features and how they combine are the paper's. Chosen beyond it,
/// as the authors' own program does: pixels beyond the border are those of the border; filters end
/// at three standard deviations of the widest; the white is D65 with chromaticity (0.31271,
/// 0.32902). Errors are not quantised. `threads` 0 takes one a core.
///
/// No published figure could be compared with: those known are of pictures that were not at hand.
/// The tests compare it with an independent implementation of the formulas, in two dimensions and
/// in double precision.
///
/// Throws Error when sizes differ, std::invalid_argument when there are not between 1 and 1,000
/// pixels a degree.
PixelMap perceptual_error(const Image8& a, const Image8& b, const Viewing& viewing = {},
                          int threads = 0);

/// Statistics of a map of errors between 0 and 1.
struct ErrorSummary {
  double mean = 0.0;
  double least = 0.0;
  double largest = 0.0;
  int largest_x = 0;  ///< where; the first row by row
  int largest_y = 0;

  /// Percentiles in which each pixel weighs as much as its error, so that many pixels without any
  /// do not hide the few: the error up to which a quarter, half, three quarters of the sum of
  /// errors lie. To 1/65,536.
  double weighted_first_quartile = 0.0;
  double weighted_median = 0.0;
  double weighted_third_quartile = 0.0;
};
ErrorSummary summary_of(const PixelMap& errors);

}  // namespace mien::render
