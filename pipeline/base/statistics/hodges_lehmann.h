#pragma once

#include <vector>

namespace mien::pipeline {

/// Where paired differences lie: the median of the means of any two of them, each with itself too
/// (Hodges and Lehmann 1963), with the interval of the signed-rank test (Tukey's).
struct HodgesLehmann {
  double estimate = 0.0;
  double low = 0.0;
  double high = 0.0;
  double confidence = 0.0;  ///< that the interval really has: at least what was asked for if it can
};

/// Differences of 0 count like any others. The ends are means of pairs whose ranks come from the
/// exact distribution of W+ without ties, or, of more than 300 differences, from its normal
/// approximation; ties make the interval wider than it need be, never narrower. With too few
/// differences for the confidence, from the least mean to the largest. NaN without differences.
HodgesLehmann hodges_lehmann(const std::vector<double>& differences, double confidence = 0.95);

}  // namespace mien::pipeline
