#pragma once

namespace mien::pipeline {

/// An interval of a share, both ends in 0 … 1.
struct ShareInterval {
  double low = 0.0;
  double high = 1.0;
};

/// Interval of the true share when `successes` of `trials` were seen (Wilson 1927), without
/// continuity correction. Successes need not be whole (points). 0 … 1 without trials.
ShareInterval wilson(double successes, double trials, double confidence = 0.95);

/// Exact p value, two-sided, of as many successes when each has the probability `chance`: all
/// outcomes that are no more probable, as R's binom.test. 1 without trials.
double binomial_test(int successes, int trials, double chance);

}  // namespace mien::pipeline
