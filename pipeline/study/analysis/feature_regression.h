#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/base/statistics/ridge_regression.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// Cross-validated prediction error of one parameter's ratings.
struct PredictionCheck {
  std::string parameter;
  std::string left_out;  ///< "example", or "style" (all takes of a style together)
  CrossValidation predictions;
  double rmse = 0.0;       ///< fraction of the scale's range
  double mean_rmse = 0.0;  ///< RMSE if the mean of the other examples is the prediction
  double r_squared = 0.0;  ///< 1 − (rmse / mean_rmse)²; below 0: worse than the mean
};

/// One parameter as a function of the motion features.
struct ParameterRegression {
  std::string parameter;
  RidgeModel model;
  Eigen::VectorXd observed;             ///< ratings of the examples, fraction of the scale's range
  std::vector<PredictionCheck> checks;  ///< by example; also by style if there are several styles
                                        ///< and one of them has several takes
  /// Of the n absolute errors of the last of `checks`, in order, that at place ⌈0.9 (n + 1)⌉, or
  /// the largest with fewer than nine (Barber et al. 2021).
  double error_90 = 0.0;
  double mean_leverage = 0.0;     ///< over the examples
  double largest_leverage = 0.0;  ///< over the examples
};

/// Regressions that predict ratings of unrated motions (proposed in the adjective paper as future
/// work).
struct FeatureRegression {
  std::vector<std::string> features;  ///< ids of the features that all examples have
  std::vector<int> feature_indices;   ///< indices of `features` in motion_features()
  std::vector<std::string> examples;
  std::vector<int> style_of_example;  ///< examples of one style have the same number
  std::vector<ParameterRegression> parameters;
  bool simulated = false;
};

/// The style of which an example is a take, from its name: "sad" for "sad_001" and "sad-2".
std::string style_of(const std::string& example);

/// Fits a ridge regression from the standardised features to each parameter of the ratings. The
/// penalty is that of best_penalty() for left-out styles or, if `checks` has no check by style, for
/// left-out examples. Throws Error if there are no ratings or fewer than
/// four examples.
FeatureRegression fit_feature_regression(const Repertoire& repertoire);

/// Predicted rating of a motion, with its uncertainty.
struct Prediction {
  std::string parameter;
  double value = 0.0;  ///< fraction of the scale's range; not clipped
  /// 90 % interval: value ± error_90 (as in the jackknife interval of Barber et al. 2021), scaled
  /// by √((1 + leverage) / (1 + mean leverage)), where the mean is over the examples.
  double low = 0.0;
  double high = 0.0;
  double leverage = 0.0;
  bool extrapolated = false;  ///< the leverage exceeds that of every example
};

/// Predicts every parameter of a motion. Throws Error if the motion lacks a feature of the
/// examples, which happens if it has no gait cycle.
std::vector<Prediction> predict(const FeatureRegression& regression,
                                const motion::FeatureValues& features);

/// A row for each parameter and kind of check.
WrittenTable checks_table(const FeatureRegression& regression, const ScaleSet& scales);

/// A row for each parameter, kind of check and example.
WrittenTable left_out_table(const FeatureRegression& regression);

}  // namespace mien::pipeline
