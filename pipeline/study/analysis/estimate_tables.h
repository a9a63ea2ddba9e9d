#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/study/analysis/rating_estimates.h"

namespace mien::pipeline {

/// Estimators of all scales, and the motions that they were fitted to.
struct RatingEstimators {
  std::vector<std::string> motions;
  std::vector<MeanRatings> ratings;        ///< one a scale
  std::vector<ScaleEstimator> estimators;  ///< aligned with `ratings`
  bool simulated = false;                  ///< whether the ratings are simulated
};

/// A new motion and its estimates, aligned with the estimators.
struct EstimatedMotion {
  std::string motion;
  std::vector<RatingEstimate> estimates;
};

/// A row for each scale: reliability, ceiling, R², share of the ceiling, p.
WrittenTable estimate_checks_table(const RatingEstimators& estimators);

/// A row for each scale and rated motion: its estimate without its style.
WrittenTable left_out_estimates_table(const RatingEstimators& estimators);

/// A row for each new motion and scale.
WrittenTable estimates_table(const std::vector<EstimatedMotion>& motions,
                             const RatingEstimators& estimators);

/// Estimates as mean answers for `ratings:` of a manifest, limited to the scales' ranges; of usable
/// scales only.
WrittenTable estimated_ratings_table(const std::vector<EstimatedMotion>& motions,
                                     const RatingEstimators& estimators, const ScaleSet& scales);

}  // namespace mien::pipeline
