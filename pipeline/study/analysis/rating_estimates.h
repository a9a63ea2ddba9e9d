#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/gaussian_process.h"

namespace mien::pipeline {

/// Mean ratings of motions on one scale. All members have one entry per motion; values are shares
/// of the scale's range.
struct MeanRatings {
  std::string scale;
  Eigen::VectorXd mean;
  Eigen::VectorXd deviation;  ///< over the answers (divided by their number); NaN for given means
  Eigen::VectorXi answers;    ///< number of answers
};

/// What the raters' disagreement leaves to explain.
struct RatingReliability {
  /// Variance of one answer about the mean of its motion, pooled over the motions (the mean square
  /// within of the one-way analysis of variance). NaN if only means are given.
  double answer_variance = 0.0;
  double icc_one_k = 0.0;  ///< ICC(1,k) of the means (Shrout and Fleiss 1979); NaN if so
};

RatingReliability reliability_of(const MeanRatings& ratings);

/// Motions whose ratings are known, as rows of features.
struct RatedMotions {
  Eigen::MatrixXd features;
  std::vector<std::vector<int>> families;  ///< columns: shape, timing, dynamics
  std::vector<int> style;                  ///< motions of one style are never separated
};

/// Estimates of rated motions by processes that were fitted without any motion of their style.
struct EstimateCheck {
  Eigen::VectorXd estimated;
  Eigen::VectorXd variance;        ///< as predicted, without the raters' error
  Eigen::VectorXd mean_of_others;  ///< mean rating of the motions of other styles
  double r_squared = 0.0;  ///< 1 − Σ(rating − estimated)² / Σ(rating − mean_of_others)²
  /// The R² expected of an estimator that knows what all people would answer on average: the
  /// errors that are left are those of the means of a few raters. NaN if only means are given.
  double ceiling = 0.0;
  double p = 1.0;        ///< of permutations: share of shuffled ratings with at least this R²
  int permutations = 0;  ///< number of shuffles
  /// Share of the ratings within the 90 % intervals of the process itself, raters' error added.
  double covered = 0.0;
};

/// A fitted estimator of one scale.
struct ScaleEstimator {
  std::string scale;
  RatingReliability reliability;
  EstimateCheck check;
  Eigen::RowVectorXd feature_mean, feature_spread;  ///< spread 0: constant, not used
  GaussianProcess process;
  /// Half width of a 90 % interval in predicted standard deviations: that of the normal
  /// distribution, 1.645, or, if larger, the 90 % quantile of the absolute standardised errors of
  /// the left-out motions (with the correction of conformal prediction for their number; Vovk et
  /// al. 2005), because point estimates of the process's parameters make its variance too small.
  double reach = 0.0;

  /// Whether the estimates say more than the mean: R² > 0 and p ≤ 0.05.
  bool is_usable() const;
  /// R² / ceiling; NaN unless the ceiling is above 0.
  double share_of_ceiling() const;
  /// Whether that is 60 % or more.
  bool reaches_aim() const;
};

inline constexpr double aimed_share_of_ceiling = 0.6;

struct EstimatorOptions {
  int permutations = 199;
  std::uint64_t seed = 1;
  /// Called after every permutation with the share of them that is done. What it throws ends the
  /// fit.
  std::function<void(double share)> progress = [](double) {};
};

/// Fits an estimator. Standardisation, parameters and constant of every left-out style are found
/// without it. Permutations exchange the ratings of whole styles, between styles with the same
/// number of motions. Throws Error if there are fewer than four styles.
ScaleEstimator fit_estimator(const RatedMotions& motions, const MeanRatings& ratings,
                             const EstimatorOptions& options = {});

/// The cross-validation alone, without permutations.
EstimateCheck check_without_styles(const RatedMotions& motions, const MeanRatings& ratings);

/// Estimated mean rating of a motion, share of the scale's range, not clipped.
struct RatingEstimate {
  double value = 0.0;
  double low_90 = 0.0;  ///< the mean answer of very many people lies between low and high
  double high_90 = 0.0;
};

RatingEstimate estimate(const ScaleEstimator& estimator, const Eigen::RowVectorXd& features);

}  // namespace mien::pipeline
