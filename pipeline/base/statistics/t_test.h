#pragma once

#include <vector>

namespace mien::pipeline {

/// A t test, two-sided.
struct TTest {
  double mean = 0.0;            ///< mean of the differences, or difference of the means
  double standard_error = 0.0;  ///< standard error of `mean`
  double degrees = 0.0;         ///< degrees of freedom
  double t = 0.0;
  double p = 1.0;

  /// Ends of the interval that holds the true mean with the given confidence, in (0, 1).
  double low(double confidence) const;
  double high(double confidence) const;
};

/// Whether values are equal except for rounding errors.
bool all_equal(const std::vector<double>& values);

/// t test of paired differences. With fewer than two differences, the standard error, t and p are
/// NaN. If all differences are equal and not 0, t is infinite and p is 0; if all are 0, t is NaN
/// and p is 1.
TTest paired_t_test(const std::vector<double>& differences);

/// t test of two independent samples with unequal variances (Welch 1947). NaN if either has fewer
/// than two values.
TTest welch_t_test(const std::vector<double>& a, const std::vector<double>& b);

/// Cohen's d_z (1988): mean of paired differences over their standard deviation (n − 1). Infinite
/// if all differences are equal and not 0; NaN if all are 0, or with fewer than two differences.
double cohens_dz(const std::vector<double>& differences);

/// Cohen's d_s (1988): difference of the means of two independent samples over their pooled
/// standard deviation. NaN with fewer than two values in either, or if neither varies.
double cohens_d(const std::vector<double>& a, const std::vector<double>& b);

/// Hedges' g of two independent samples: cohens_d corrected for bias. NaN as for cohens_d.
double hedges_g(const std::vector<double>& a, const std::vector<double>& b);

/// Hedges' g_z of paired differences: cohens_dz corrected for bias. NaN with fewer than three
/// differences; if all differences are equal, as for cohens_dz.
double hedges_gz(const std::vector<double>& differences);

}  // namespace mien::pipeline
