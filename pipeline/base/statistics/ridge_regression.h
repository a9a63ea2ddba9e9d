#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// A linear prediction of one number from several, with shrunk coefficients (Hoerl and Kennard
/// 1970): least Σ (y − ŷ)² + penalty · Σ b², over standardised predictors.
struct RidgeModel {
  Eigen::RowVectorXd mean;          ///< of each predictor over the observations
  Eigen::RowVectorXd spread;        ///< standard deviation (n); 0: constant, not used
  Eigen::RowVectorXd coefficients;  ///< of the standardised predictors
  double intercept = 0.0;           ///< mean of the observed values
  double penalty = 0.0;
  int observations = 0;
  Eigen::MatrixXd inverse;  ///< (ZᵀZ + penalty·I)⁻¹ of the standardised predictors Z
};

/// Fits to observations: one row of predictors and one value each, n ≥ 2, penalty > 0.
RidgeModel fit_ridge(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                     double penalty);

double predicted(const RidgeModel& model, const Eigen::RowVectorXd& predictors);

/// How far from the observations a prediction is made: 1/n + zᵀ(ZᵀZ + penalty·I)⁻¹z. Of an
/// observation itself it is its weight in its own prediction, below 1.
double leverage(const RidgeModel& model, const Eigen::RowVectorXd& predictors);

/// Penalties from n/1000 to 1000·n, evenly on a logarithmic scale.
std::vector<double> penalty_choices(int observations);

/// The largest penalty whose predictions of what is left out err (sum of squares) at most a
/// standard error more than those of the best one (the one-standard-error rule of Breiman et al.
/// 1984): with few observations the best one is best by luck. Groups of observations are left out
/// together; `group` names each observation's. Standardisation stays that of all observations.
double best_penalty(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                    std::span<const int> group);

/// Predictions of observations by models that never saw them.
struct CrossValidation {
  Eigen::VectorXd predicted;
  Eigen::VectorXd mean_predicted;  ///< by the mean of the others, for comparison
  Eigen::VectorXd penalty;         ///< chosen for each without it

  double rmse(const Eigen::VectorXd& values) const;
  double mean_rmse(const Eigen::VectorXd& values) const;
  /// 1 − Σ(y − ŷ)²/Σ(y − mean of the others)²: 0 is no better than the mean, and it may be less.
  double r_squared(const Eigen::VectorXd& values) const;
};

/// Leaves out each group in turn, standardises, chooses the penalty and fits without it, and
/// predicts it. There must be two groups or more.
CrossValidation cross_validate(const Eigen::MatrixXd& predictors, const Eigen::VectorXd& values,
                               std::span<const int> group);

}  // namespace mien::pipeline
