#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// Mean and standard deviation of each predictor (divided by the number of rows), by which
/// predictors get equal spreads.
struct Standardisation {
  Eigen::RowVectorXd mean;
  Eigen::RowVectorXd spread;  ///< 0: constant to within rounding

  /// The predictors minus their mean, divided by the spread; 0 where that is 0.
  Eigen::MatrixXd of(const Eigen::MatrixXd& predictors) const;
};

Standardisation standardisation_of(const Eigen::MatrixXd& predictors);

/// Observations of a value at places given by predictors. All members have one entry or row per
/// observation.
struct GroupedObservations {
  Eigen::MatrixXd predictors;  ///< should have similar spreads, as after standardisation
  Eigen::VectorXd values;
  Eigen::VectorXd noise_variance;  ///< known variance of each value's error, ≥ 0
  std::vector<int> group;          ///< observations of one group share a deviation

  int count() const { return static_cast<int>(values.size()); }
};

/// The variances and the reach of a Gaussian process, as natural logarithms of standard deviations
/// and of a length.
struct ProcessParameters {
  Eigen::VectorXd log_amplitude;  ///< of the function of each family of predictors
  double log_group = 0.0;         ///< deviation shared by a group
  double log_own = 0.0;           ///< deviation of each observation beyond its known noise
  double log_length = 0.0;        ///< distance over which the functions change
};

/// Gaussian process regression (Rasmussen and Williams 2006, chapters 2 and 5) of a sum of smooth
/// functions, one of each family of predictors:
///
///   value = m + Σ_f g_f(x_f) + (deviation of the group) + (own deviation) + (known noise),
///
/// where g_f has the covariance a_f² · exp(−d_f² / (2 l²)), and d_f² is the mean squared difference
/// of the family's predictors. The constant m has a flat prior and is integrated out (their section
/// 2.7). The deviation of the group states that observations of one group err together: without it,
/// ten takes of one style would count as ten independent facts.
struct GaussianProcess {
  std::vector<std::vector<int>> families;  ///< columns of the predictors
  ProcessParameters parameters;
  GroupedObservations observations;
  double log_evidence = 0.0;  ///< log marginal likelihood of `parameters` plus their log prior
  Eigen::MatrixXd inverse;    ///< of the covariance of the observations
  Eigen::VectorXd weights;    ///< inverse · (values − m)
  double constant = 0.0;      ///< estimate of m
};

/// The process with given parameters. Requires at least two observations, and for each family at
/// least one column.
GaussianProcess process_with(const std::vector<std::vector<int>>& families,
                             const GroupedObservations& observations,
                             const ProcessParameters& parameters);

/// The process with the most probable parameters: the maximum of marginal likelihood times prior
/// (BFGS with analytic gradients). The priors are normal on the logarithms: amplitudes
/// around 0.7·sd/√families, the deviation of groups around 0.37·sd, the own deviation around
/// 0.22·sd (each with standard deviation 1; sd is the standard deviation of the values), the length
/// around 1 (0.5). The maximum does not depend on shifting the values, and scales with them.
GaussianProcess fit_process(const std::vector<std::vector<int>>& families,
                            const GroupedObservations& observations);

/// The parameters around which those priors are, for values with the standard deviation `spread`.
ProcessParameters usual_parameters(std::size_t families, double spread);

/// Log marginal likelihood (up to the constant of the flat prior of m) of the parameters without
/// their prior.
double log_likelihood(const std::vector<std::vector<int>>& families,
                      const GroupedObservations& observations, const ProcessParameters& parameters);

/// Normal distribution of the value of a new observation of a new group, without measurement noise.
struct ProcessPrediction {
  double mean = 0.0;
  double variance = 0.0;
};

ProcessPrediction predicted(const GaussianProcess& process, const Eigen::RowVectorXd& predictors);

/// Joint normal distribution of the constant plus the functions, without any deviations, at several
/// places: one row of predictors each.
struct JointPrediction {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

JointPrediction jointly_predicted(const GaussianProcess& process,
                                  const Eigen::MatrixXd& predictors);

/// The same before anything is observed: the functions are 0 on average, and the constant is normal
/// about 0 with this variance.
JointPrediction prior_prediction(const std::vector<std::vector<int>>& families,
                                 const ProcessParameters& parameters,
                                 const Eigen::MatrixXd& predictors, double constant_variance);

/// What the process says about each observation if that observation is left out and the parameters
/// stay as they are: the normal distribution of its value, measurement noise included (Dubrule
/// 1983; Rasmussen and Williams 2006, section 5.4.2). Requires three observations.
std::vector<ProcessPrediction> left_out_predictions(const GaussianProcess& process);

/// Variance by which the value of an observation of a new group differs from the functions, without
/// measurement noise.
double deviation_variance(const ProcessParameters& parameters);

}  // namespace mien::pipeline
