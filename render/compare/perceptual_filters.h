#pragma once

#include "render/compare/separable.h"

namespace mien::render {

/// The contrast sensitivity of the eye as filters of the three opponent channels (Andersson et al.
/// 2020, section 4.1.1, table 1): sums of Gaussians a · √(π/b) · exp(−π² d² / b), d in degrees, of
/// sum 1 over all pixels up to `reach`. Both sums of two are separable part by part.
struct ContrastFilters {
  HalfKernel achromatic;          ///< of y:  a = 1, b = 0.0047
  HalfKernel red_green;           ///< of cx: a = 1, b = 0.0053
  HalfKernel blue_yellow;         ///< of cz, the wide part: a = 34.1, b = 0.04
  HalfKernel blue_yellow_narrow;  ///< and the other: a = 13.5, b = 0.025
  float wide_share = 1.0f;        ///< of the wide part in the sum; the rest is the other's
};

/// The filters for a resolution, cut off at three standard deviations of the widest, in whole
/// pixels, as the authors do.
ContrastFilters contrast_filters(double pixels_per_degree);

/// Detectors of edges and points (section 4.2): first and second derivative of a Gaussian whose
/// standard deviation is half of 0.082 degrees, along one axis, smoothed along the other. Positive
/// weights of each add up to 1 over all pixels and negative ones to −1: a step from 0 to 1 at the
/// centre of the edge detector gives 1 at most.
struct FeatureFilters {
  HalfKernel smooth;  ///< even, of sum 1
  HalfKernel edge;    ///< odd
  HalfKernel point;   ///< even
};

/// The detectors for a resolution, cut off at three standard deviations, in whole pixels.
FeatureFilters feature_filters(double pixels_per_degree);

}  // namespace mien::render
