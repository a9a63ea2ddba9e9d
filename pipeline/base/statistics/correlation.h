#pragma once

#include <vector>

namespace mien::pipeline {

/// Pearson correlation of two variables. Everything except `pairs` is NaN for fewer than three
/// pairs, or if one variable is constant.
struct Correlation {
  int pairs = 0;
  double r = 0.0;
  double t = 0.0;     ///< with pairs − 2 degrees of freedom
  double p = 1.0;     ///< two-sided
  double low = -1.0;  ///< confidence interval by Fisher's z (1921); NaN below four pairs
  double high = 1.0;
};

/// `a` and `b` have the same length; pairs with NaN in either are omitted.
Correlation pearson(const std::vector<double>& a, const std::vector<double>& b,
                    double confidence = 0.95);

}  // namespace mien::pipeline
