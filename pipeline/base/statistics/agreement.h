#pragma once

#include <Eigen/Core>

namespace mien::pipeline {

/// Reliability of ratings of stimuli (Shrout and Fleiss 1979), also if each rater saw only part of
/// the stimuli. NaN where undefined. Estimates may be negative; they are not truncated at 0.
struct Intraclass {
  int stimuli = 0;
  int raters = 0;
  int answers = 0;
  double answers_per_stimulus = 0.0;  ///< k₀ = (N − Σn²/N)/(stimuli − 1) of unequal numbers n
  bool is_connected = false;  ///< whether all raters can be compared, through common stimuli
  double one = 0.0;           ///< ICC(1): of one answer, each stimulus by other raters
  double one_k = 0.0;         ///< ICC(1,k): of a mean of k₀ answers
  double two = 0.0;           ///< ICC(2,1): raters a random sample, agreement
  double two_k = 0.0;         ///< ICC(2,k)
  double three = 0.0;         ///< ICC(3,1): these raters, consistency
  double three_k = 0.0;       ///< ICC(3,k): Cronbach's alpha of a full table
};

/// Intraclass correlations of a table, stimuli × raters, with NaN for missing answers.
///
/// The rule for missing cells: every answer counts and nothing is filled in. ICC(1) are of the
/// one-way analysis of variance of all answers. ICC(2) and ICC(3) come from variance components by
/// the method of fitting constants (Henderson 1953, method 3): stimuli after raters, raters after
/// stimuli, and what is left. In a full table these are the mean squares of Shrout and Fleiss, and
/// so are the results. Stimuli without answers and raters without any do not count; where the
/// table falls apart into groups without common raters, ICC(2) and ICC(3) are NaN.
Intraclass intraclass(const Eigen::MatrixXd& answers);

/// Agreement of raters about the stimuli on one scale. NaN where undefined: fewer than two raters
/// or stimuli, or all answers equal.
struct Agreement {
  int complete_raters = 0;  ///< raters who rated every stimulus; alpha and icc_2_k are of these
  double alpha = 0.0;       ///< Cronbach 1951, raters as items; equals ICC(3,k)
  double icc_2_k = 0.0;     ///< mean of the raters, raters a random sample
  Intraclass all;           ///< of all answers, also of raters who saw a part of the stimuli
};

/// Cronbach's alpha k/(k − 1)·(1 − Σ variance of a rater / variance of the raters' sums) of a full
/// table, stimuli × raters.
double cronbach_alpha(const Eigen::MatrixXd& answers);

/// Computes all of these from a table, stimuli × raters, with NaN for missing answers.
Agreement agreement_of(const Eigen::MatrixXd& answers);

}  // namespace mien::pipeline
