#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// Ridge regression (Hoerl and Kennard 1970): minimises Σ (y − ŷ)² + penalty · Σ b² over
/// standardised predictors.
struct RidgeModel {
  Eigen::RowVectorXd mean;          ///< mean of each predictor over the observations
  Eigen::RowVectorXd spread;        ///< standard deviation (divisor n); 0: constant, not used
  Eigen::RowVectorXd coefficients;  ///< coefficients of the standardised predictors
  double intercept = 0.0;           ///< mean of the observed values
  double penalty = 0.0;
  int observations = 0;
  Eigen::MatrixXd inverse;  ///< (ZᵀZ + penalty·I)⁻¹ of the standardised predictors Z
};

/// Fits a model to n ≥ 2 observations, each with a row of predictors and a value; penalty > 0.
RidgeModel fit_ridge(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                     double penalty);

double predicted(const RidgeModel& model, const Eigen::RowVectorXd& predictors);

/// Leverage of a prediction, its distance from the observations: 1/n + zᵀ(ZᵀZ + penalty·I)⁻¹z. The
/// leverage of a fitted observation is the weight of its value in its own prediction: below 1.
double leverage(const RidgeModel& model, const Eigen::RowVectorXd& predictors);

/// Penalties from n/1000 to 1000·n for n observations, evenly spaced on a logarithmic scale.
std::vector<double> penalty_choices(int observations);

/// The largest penalty whose cross-validated sum of squared errors exceeds the least by at most one
/// standard error (one-standard-error rule, Breiman et al. 1984), because with few observations the
/// minimum is unreliable. Observations of a group are held out together; `group` contains the group
/// of each observation. All observations are used for standardisation.
double best_penalty(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                    std::span<const int> group);

/// Predictions of observations by models fitted without them.
struct CrossValidation {
  Eigen::VectorXd predicted;
  Eigen::VectorXd mean_predicted;  ///< mean value of the observations of other groups
  Eigen::VectorXd penalty;         ///< chosen for each observation without its group

  double rmse(const Eigen::VectorXd& values) const;
  double mean_rmse(const Eigen::VectorXd& values) const;
  /// 1 − Σ(y − ŷ)²/Σ(y − mean of the others)²: 0 means no better than that mean, and negative
  /// values mean worse.
  double r_squared(const Eigen::VectorXd& values) const;
};

/// Holds out each group in turn: standardises, chooses the penalty and fits with the other groups,
/// then predicts the values of the held-out group. Requires at least two groups, each of which
/// leaves at least two observations in the others.
CrossValidation cross_validate(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                               std::span<const int> group);

}  // namespace mien::pipeline
