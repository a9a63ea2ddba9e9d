#pragma once

#include <Eigen/Core>

namespace mien::pipeline {

/// Reliability of ratings of stimuli (Shrout and Fleiss 1979), also if not every rater saw all
/// stimuli. Coefficients are NaN where undefined. They may be negative; they are not truncated at
/// 0.
struct Intraclass {
  int stimuli = 0;
  int raters = 0;
  int answers = 0;
  /// The number k₀ = (N − Σn²/N)/(stimuli − 1) for n answers per stimulus and N in total; 0 for
  /// fewer than two stimuli.
  double answers_per_stimulus = 0.0;
  /// Whether all raters can be compared, through common stimuli. Not determined, and false, for
  /// fewer than two stimuli, if all answers are equal, or if no stimulus has two answers.
  bool is_connected = false;
  double one = 0.0;    ///< ICC(1): of one answer, with different raters for each stimulus
  double one_k = 0.0;  ///< ICC(1,k): of a mean of k₀ answers
  double two = 0.0;    ///< ICC(2,1): raters as a random sample, absolute agreement
  double two_k = 0.0;  ///< ICC(2,k): of a mean of k₀ answers
  double three = 0.0;  ///< ICC(3,1): fixed raters, consistency
  /// ICC(3,k): of a mean of k₀ answers; Cronbach's alpha for a complete table.
  double three_k = 0.0;
};

/// Intraclass correlations of a table, stimuli × raters, with NaN for missing answers.
///
/// Missing cells: all answers are used, and none are imputed. ICC(1) is that of the one-way
/// analysis of variance of all answers. ICC(2) and ICC(3) use variance components estimated by the
/// method of fitting constants (Henderson 1953, method 3): stimuli after raters, raters after
/// stimuli, and the residual. For a complete table these reduce to the mean squares of Shrout and
/// Fleiss, with the same results. Stimuli and raters without answers are ignored; if the table
/// consists of groups without common raters or stimuli, ICC(2) and ICC(3) are NaN.
Intraclass intraclass(const Eigen::MatrixXd& answers);

/// Agreement of raters about the stimuli on one scale. Coefficients are NaN where undefined, for
/// example for fewer than two raters or stimuli, or if all answers are equal.
struct Agreement {
  int complete_raters = 0;  ///< number of raters who rated every stimulus
  double alpha = 0.0;       ///< of complete raters: Cronbach 1951, raters as items; equals ICC(3,k)
  double icc_2_k = 0.0;     ///< of complete raters: ICC(2,k) of their mean
  Intraclass all;           ///< of all raters, including incomplete ones
};

/// Cronbach's alpha of a complete table, stimuli × raters: k/(k − 1)·(1 − Σ variance of a rater /
/// variance of the sums over raters).
double cronbach_alpha(const Eigen::MatrixXd& answers);

/// Computes the agreement from a table, stimuli × raters, with NaN for missing answers.
Agreement agreement_of(const Eigen::MatrixXd& answers);

}  // namespace mien::pipeline
