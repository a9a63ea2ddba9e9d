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
  std::string left_out;  ///< "example", or "style": all takes of a style together
  CrossValidation predictions;
  double rmse = 0.0;       ///< share of the scale
  double mean_rmse = 0.0;  ///< RMSE of predicting the mean of the others
  double r_squared = 0.0;  ///< 1 − (rmse / mean_rmse)²; below 0: worse than the mean
};

/// One parameter as a function of the motion features.
struct ParameterRegression {
  std::string parameter;
  RidgeModel model;
  Eigen::VectorXd observed;             ///< of the examples, share of the scale
  std::vector<PredictionCheck> checks;  ///< by example and, where styles have several takes, style
  double error_90 = 0.0;  ///< 90th percentile of the errors of the last, hardest check
  double mean_leverage = 0.0;
  double largest_leverage = 0.0;  ///< of the examples
};

/// Regressions that predict ratings of unrated motions (future work of the adjective paper).
struct FeatureRegression {
  std::vector<std::string> features;  ///< ids of those that all examples have
  std::vector<int> feature_indices;
  std::vector<std::string> examples;
  std::vector<int> style_of_example;  ///< examples of one style have the same number
  std::vector<ParameterRegression> parameters;
  bool simulated = false;
};

/// Names of the styles that examples are takes of: "sad" of "sad_001", "sad-2" and "sad 2".
std::string style_of(const std::string& example);

/// Fits a ridge regression from the features (each standardised) to each parameter of the ratings;
/// the penalty is the one that predicts left-out styles best. Throws Error when there are no
/// ratings or fewer than four examples.
FeatureRegression fit_feature_regression(const Repertoire& repertoire);

/// Predicted rating of a motion, with its uncertainty.
struct Prediction {
  std::string parameter;
  double value = 0.0;  ///< share of the scale; not clipped
  /// 90 % interval: value ± the 90th percentile of the errors on left-out examples (the jackknife
  /// interval of Barber et al. 2021), widened by √((1 + leverage) / (1 + that of the examples)).
  double low = 0.0;
  double high = 0.0;
  double leverage = 0.0;
  bool extrapolated = false;  ///< farther from the examples than any of them is from the others
};

std::vector<Prediction> predict(const FeatureRegression& regression,
                                const motion::FeatureValues& features);

/// A row for each parameter and kind of check.
WrittenTable checks_table(const FeatureRegression& regression, const ScaleSet& scales);

/// A row for each parameter, kind of check and example.
WrittenTable left_out_table(const FeatureRegression& regression);

}  // namespace mien::pipeline
