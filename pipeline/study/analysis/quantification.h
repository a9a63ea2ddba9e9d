#pragma once

#include <string>
#include <vector>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// When a scale is removed, for answers from −2 to 2 (the adjective paper, section 3.1). For a
/// scale with another range both are restated in proportion to its half width.
struct Thresholds {
  double largest_mean = 1.0;     ///< max over examples of |mean|; below it the scale is neutral
  double mean_deviation = 0.85;  ///< mean over examples of the SD; above it raters disagree
};

/// Divisor of the variance of the answers about one example: n, or n − 1.
enum class Deviation { population, sample };

/// Statistics of the answers on one scale, in the scale's own units.
struct Quantity {
  std::string scale;
  double largest_mean = 0.0;    ///< max over examples of the mean's distance from the middle
  int extreme_example = 0;      ///< the first example with that distance
  double mean_deviation = 0.0;  ///< mean over examples of the SD over raters; NaN for given means
  Thresholds thresholds;        ///< restated for this scale
  bool neutral = false;         ///< largest_mean < threshold
  bool disputed = false;        ///< mean_deviation > threshold

  bool retained() const { return !neutral && !disputed; }
};

/// One quantity for each row of the impressions, in their order.
std::vector<Quantity> quantify(const Impressions& impressions, const ScaleSet& scales,
                               const Thresholds& thresholds = {},
                               Deviation deviation = Deviation::population);

/// The number of scales that other thresholds would retain.
struct ThresholdPoint {
  enum class Condition { largest_mean, mean_deviation };

  Condition condition = Condition::largest_mean;  ///< whose threshold is varied
  double threshold = 0.0;                         ///< for answers from −2 to 2
  int by_condition = 0;                           ///< scales retained by this condition alone
  int by_both = 0;                                ///< retained with the other threshold unchanged
};

/// Both thresholds from 0 to 2 in steps of 0.05.
std::vector<ThresholdPoint> threshold_curve(const std::vector<Quantity>& quantities,
                                            const Thresholds& thresholds, const ScaleSet& scales);

/// Thresholds that retain at least half of the scales: both relaxed by the same, least factor
/// (the one divided by it, the other multiplied), rounded to the loose side to 0.01. A threshold
/// that no scale misses is unchanged. Returns `thresholds` when they retain that many already.
Thresholds loosened_thresholds(const std::vector<Quantity>& quantities,
                               const Thresholds& thresholds, const ScaleSet& scales);

/// The number of scales that each threshold retains: a panel for each condition; thin line by the
/// condition alone, thick line with the other threshold unchanged, dashed line at the threshold in
/// use. `scales`: how many were rated.
Plot threshold_chart(const std::vector<ThresholdPoint>& curve, const Thresholds& thresholds,
                     int scales, bool simulated);

}  // namespace mien::pipeline
