#pragma once

#include <Eigen/Core>

#include "pipeline/base/statistics/intraclass.h"

namespace mien::pipeline {

/// How well raters agree about the stimuli on one scale. NaN where it cannot be said: fewer than
/// two raters or stimuli, or nothing but equal answers.
struct Agreement {
  int complete_raters = 0;  ///< who answered about every stimulus; alpha and icc_2_k are theirs
  double alpha = 0.0;       ///< Cronbach 1951, raters as items; equals ICC(3,k)
  double icc_2_k = 0.0;     ///< mean of the raters, raters a random sample
  Intraclass all;           ///< of all answers, also of raters who saw a part of the stimuli
};

/// Cronbach's alpha k/(k − 1)·(1 − Σ variance of a rater / variance of the raters' sums) of a full
/// table, stimuli × raters.
double cronbach_alpha(const Eigen::MatrixXd& answers);

/// All of them from a table with NaN where there is no answer, stimuli × raters.
Agreement agreement_of(const Eigen::MatrixXd& answers);

}  // namespace mien::pipeline
