#pragma once

namespace mien::pipeline {

/// A confidence interval of a proportion, both ends in 0 … 1.
struct ShareInterval {
  double low = 0.0;
  double high = 1.0;
};

/// Confidence interval of a proportion given `successes` in `trials` (Wilson 1927), without
/// continuity correction. `successes` need not be a whole number. 0 … 1 without trials.
ShareInterval wilson(double successes, double trials, double confidence = 0.95);

/// Exact two-sided binomial test of `successes` against the probability `chance`: the total
/// probability of all outcomes that are no more probable than the observed one, as in R's
/// binom.test. 1 without trials.
double binomial_test(int successes, int trials, double chance);

}  // namespace mien::pipeline
