#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// Thresholds for removing a scale, for answers from −2 to 2 (adjective paper, section 3.1). For
/// scales with another range, both are multiplied by the ratio of the half widths.
struct Thresholds {
  double largest_mean = 1.0;     ///< max over examples of |mean|: a scale with less is neutral
  double mean_deviation = 0.85;  ///< mean over examples of the SD: a scale with more is disputed
};

/// Divisor of the variance of the answers about one example: n, or n − 1.
enum class Deviation { population, sample };

/// Statistics of the answers on one scale, in the scale's own units.
struct Quantity {
  std::string scale;
  double largest_mean = 0.0;  ///< max over examples of the mean's distance from the scale's middle
  int extreme_example = 0;    ///< index of the first example with that distance
  /// Mean over examples of the SD over raters; NaN if that of an example is unknown.
  double mean_deviation = 0.0;
  Thresholds thresholds;  ///< for the range of this scale
  bool neutral = false;   ///< largest_mean < threshold
  bool disputed = false;  ///< mean_deviation > threshold

  bool retained() const { return !neutral && !disputed; }
};

/// Statistics of each row of the impressions, in their order.
std::vector<Quantity> quantify(const Impressions& impressions, const ScaleSet& scales,
                               const Thresholds& thresholds = {},
                               Deviation deviation = Deviation::population);

/// The number of scales that another threshold would retain.
struct ThresholdPoint {
  enum class Condition { largest_mean, mean_deviation };

  Condition condition = Condition::largest_mean;  ///< the condition whose threshold varies
  double threshold = 0.0;                         ///< varied threshold, for answers from −2 to 2
  int by_condition = 0;                           ///< scales retained by this condition alone
  int by_both = 0;  ///< scales retained by both, with the other threshold unchanged
};

/// The numbers of retained scales as each threshold varies from 0 to 2 in steps of 0.05.
std::vector<ThresholdPoint> threshold_curve(const std::vector<Quantity>& quantities,
                                            const Thresholds& thresholds, const ScaleSet& scales);

/// Thresholds that retain at least half of the scales or, if fewer can be retained by relaxing the
/// thresholds, all of these. Both are relaxed by the same smallest sufficient factor (largest_mean
/// divided by it, mean_deviation multiplied) and rounded to 0.01 so that they become looser. A
/// threshold that every scale meets is unchanged. Returns `thresholds` if they already retain half
/// of the scales, or if none can be retained.
Thresholds loosened_thresholds(const std::vector<Quantity>& quantities,
                               const Thresholds& thresholds, const ScaleSet& scales);

/// A chart of the number of retained scales over the threshold, one panel per condition: the thin
/// line is for the condition alone, the thick line for both with the other threshold unchanged, and
/// the dashed line marks the threshold in use. `scales` is the number of rated scales.
Plot threshold_chart(const std::vector<ThresholdPoint>& curve, const Thresholds& thresholds,
                     int scales, bool simulated);

}  // namespace mien::pipeline
