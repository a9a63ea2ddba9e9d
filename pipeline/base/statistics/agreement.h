#pragma once

#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// How well raters agree about the stimuli on one scale. NaN where it cannot be said: fewer than
/// two raters or stimuli, or nothing but equal answers.
struct Agreement {
  int raters = 0;           ///< who answered at all
  int complete_raters = 0;  ///< who answered about every stimulus; alpha and icc_2_k are theirs
  double alpha = 0.0;       ///< Cronbach 1951, raters as items; equals ICC(3,k)
  double icc_2_k = 0.0;     ///< Shrout and Fleiss 1979: mean of the raters, raters a random sample
  double answers_per_stimulus = 0.0;  ///< the k₀ of icc_1_k
  double icc_1_k = 0.0;  ///< one-way: each stimulus rated by other people; all answers count
};

/// Cronbach's alpha k/(k − 1)·(1 − Σ variance of a rater / variance of the raters' sums) of a full
/// table, stimuli × raters.
double cronbach_alpha(const Eigen::MatrixXd& answers);

/// ICC(2,k) = (MSR − MSE)/(MSR + (MSC − MSE)/n) of a full table, stimuli × raters.
double icc_2_k(const Eigen::MatrixXd& answers);

/// ICC(1,k) = (MSB − MSW)/MSB of the answers about each stimulus, whoever gave them; with k₀ =
/// (N − Σn²/N)/(stimuli − 1) answers a stimulus where their numbers n differ it is the reliability
/// of a mean of k₀ answers.
double icc_1_k(const std::vector<std::vector<double>>& answers_by_stimulus);

/// All of them from a table with NaN where there is no answer, stimuli × raters.
Agreement agreement_of(const Eigen::MatrixXd& answers);

}  // namespace mien::pipeline
