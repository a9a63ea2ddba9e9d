#pragma once

#include "pipeline/base/adaptive/quest_plus.h"

namespace mien::pipeline {

/// The posterior distribution of the threshold, the level at which a psychometric function gives a
/// proportion of positive answers, from that of its parameters (psychometric_quest). Functions that
/// do not reach the proportion have no threshold.
struct ThresholdPosterior {
  double mean;       ///< of the functions that have one; NaN if none does, like the others
  double deviation;  ///< standard deviation
  double low;        ///< ends of the credible interval: quantiles
  double high;
  double without = 0.0;  ///< probability that there is no threshold
};

ThresholdPosterior threshold_posterior(const QuestPlus& quest, const Eigen::VectorXd& posterior,
                                       double proportion, double credibility = 0.95);

}  // namespace mien::pipeline
