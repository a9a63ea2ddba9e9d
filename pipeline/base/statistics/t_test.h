#pragma once

#include <vector>

namespace mien::pipeline {

/// A t test, two-sided.
struct TTest {
  double mean = 0.0;            ///< of the differences, or difference of the means
  double standard_error = 0.0;  ///< of that
  double degrees = 0.0;         ///< of freedom
  double t = 0.0;
  double p = 1.0;

  /// Ends of the interval that holds the true mean with the given confidence, in (0, 1).
  double low(double confidence) const;
  double high(double confidence) const;
};

/// Whether values are the same but for roundings.
bool all_alike(const std::vector<double>& values);

/// Of paired differences. With fewer than two, t and p are NaN; when all are equal t is infinite
/// and p is 0, or NaN and 1 when all are 0.
TTest paired_t_test(const std::vector<double>& differences);

/// Of two independent samples with variances of their own (Welch 1947). Each needs two values.
TTest welch_t_test(const std::vector<double>& a, const std::vector<double>& b);

/// Mean of the differences in units of their standard deviation (n − 1): d_z of Cohen 1988.
double cohens_dz(const std::vector<double>& differences);

/// Difference of the means of two independent samples in units of their pooled standard deviation:
/// d_s of Cohen 1988. NaN with fewer than two values in either, or where nothing varies.
double cohens_d(const std::vector<double>& a, const std::vector<double>& b);

/// g of two independent samples.
double hedges_g(const std::vector<double>& a, const std::vector<double>& b);

/// g_z of paired differences.
double hedges_gz(const std::vector<double>& differences);

}  // namespace mien::pipeline
