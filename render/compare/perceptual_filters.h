#pragma once

#include "render/compare/separable.h"

namespace mien::render {

/// The contrast sensitivity of the eye as filters of the three opponent channels (Andersson et al.
/// 2020, section 4.1.1, table 1): sums of Gaussians a · √(π/b) · exp(−π² d² / b), with d in degrees
/// of visual angle, normalised to sum 1. The blue–yellow filter is a sum of two Gaussians, each of
/// which is separable.
struct ContrastFilters {
  HalfKernel achromatic;          ///< for y: a = 1, b = 0.0047
  HalfKernel red_green;           ///< for cx: a = 1, b = 0.0053
  HalfKernel blue_yellow;         ///< for cz, wide Gaussian: a = 34.1, b = 0.04
  HalfKernel blue_yellow_narrow;  ///< for cz, narrow Gaussian: a = 13.5, b = 0.025
  float wide_share = 1.0f;        ///< weight of the wide Gaussian; the narrow one has the rest
};

/// Returns the filters for a resolution, cut off at three standard deviations of the widest
/// Gaussian, in whole pixels, as in the authors' implementation.
ContrastFilters contrast_filters(double pixels_per_degree);

/// Detectors of edges and points (section 4.2): the first and second derivatives, along one axis,
/// of a Gaussian with a standard deviation of 0.041 degrees (half of 0.082), smoothed along the
/// other axis. The positive weights of `edge` and of `point` add up to 1 and the negative ones to
/// −1, so that the edge detector's response to a step from 0 to 1 is at most 1.
struct FeatureFilters {
  HalfKernel smooth;  ///< even, of sum 1
  HalfKernel edge;    ///< odd
  HalfKernel point;   ///< even
};

/// Returns the detectors for a resolution, cut off at three standard deviations, in whole pixels.
FeatureFilters feature_filters(double pixels_per_degree);

}  // namespace mien::render
