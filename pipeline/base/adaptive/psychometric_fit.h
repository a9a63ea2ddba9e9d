#pragma once

#include <vector>

#include "pipeline/base/adaptive/interval_ends.h"
#include "pipeline/base/adaptive/psychometric_function.h"

namespace mien::pipeline {

/// Answers at one level.
struct LevelCount {
  double level = 0.0;
  int trials = 0;
  int positive = 0;  ///< correct, "yes" or "different"
};

/// A rate that is fixed, if both ends are the same, or estimated between them.
struct RateRange {
  double least = 0.0;
  double most = 0.0;

  bool is_estimated() const { return least < most; }
};

/// Which function is fitted. The largest guess and lapse rates must have a sum below 1.
struct PsychometricModel {
  Sigmoid sigmoid = Sigmoid::logistic;
  /// γ: 1/m for m alternatives. In yes–no and same–different trials it is the rate of false alarms,
  /// and should be estimated, for example in 0 … 0.5.
  RateRange guess = {0.5, 0.5};
  /// λ: 0 … 0.06, as in Wichmann and Hill (2001a). If it is fixed at 0, a single lapse at an easy
  /// level distorts threshold and slope; without a bound, it takes the place of a shallow slope.
  RateRange lapse = {0.0, 0.06};
};

/// Why answers do not determine location and width.
enum class FitProblem {
  none,
  no_trials,
  all_negative,
  all_positive,
  too_few_levels,  ///< fewer levels with trials than estimated parameters
  not_rising,      ///< no function fits better than a constant
  step,            ///< no function fits better than a step: the width is 0
};

struct PsychometricFit {
  FitProblem problem = FitProblem::none;
  PsychometricFunction function;  ///< location, width and estimated rates are NaN if not determined
  /// Σ k ln ψ + (n − k) ln(1 − ψ): the maximum, or the limit that it approaches if the answers do
  /// not determine the function. The logarithms of binomial coefficients are left out.
  double log_likelihood = 0.0;
  /// 2·(log-likelihood of the observed proportions − `log_likelihood`) (Wichmann and Hill 2001a,
  /// eq. 4). Answers at the same level are pooled.
  double deviance = 0.0;
  /// The levels between which the step lies (equal if it lies at a level); otherwise NaN.
  IntervalEnds step;
};

/// Levels in ascending order, equal levels pooled, without those that have no trials.
std::vector<LevelCount> pooled_levels(std::vector<LevelCount> counts);

/// Fits a psychometric function by maximum likelihood, with all answers treated as independent
/// (Wichmann and Hill 2001a). Fisher scoring with Levenberg's damping and bounds, from the best
/// four points of a grid of starts, until no parameter changes by more than 1e-10 of the levels'
/// range. Counts must be 0 ≤ positive ≤ trials and levels finite. The result does not depend on the
/// order of the counts, nor on unit and origin of the levels.
PsychometricFit psychometric_fit(const std::vector<LevelCount>& counts,
                                 const PsychometricModel& model);

}  // namespace mien::pipeline
