#pragma once

#include <vector>

namespace mien::pipeline {

/// Method for the two-sided p value.
enum class WilcoxonMode {
  exact,      ///< the distribution of W+ over all signs of the observed ranks, including ties
  published,  ///< normal approximation without continuity correction, as in the adjective paper
  corrected,  ///< as `published`, with continuity correction, as in R's wilcox.test(exact = FALSE)
};

/// Treatment of differences of 0.
enum class WilcoxonZeros {
  wilcox,  ///< dropped before ranking (Wilcoxon 1945)
  pratt,   ///< ranked with the others, then dropped (Pratt 1959)
  zsplit,  ///< ranked with the others; half of each rank counts for either sign
};

/// The signed-rank test of paired differences.
struct Wilcoxon {
  int pairs = 0;  ///< number of all differences
  int used = 0;   ///< number of differences that are not 0
  int zeros = 0;  ///< number of differences of 0
  int tied = 0;   ///< number of differences, not 0, whose absolute value occurs more than once
  /// Sum of the mid-ranks of the positive differences: the V of R. With WilcoxonZeros::zsplit, half
  /// the sum of the ranks of zeros is added to W+ and half to W−.
  double w_plus = 0.0;
  double w_minus = 0.0;  ///< sum of the mid-ranks of the negative differences
  double z = 0.0;        ///< z statistic of the normal approximations; 0 for the exact mode
  double p = 1.0;        ///< two-sided; 1 when every difference is 0, NaN without differences
  /// (W+ − W−)/(W+ + W−) without the ranks of zeros, matched pairs (Kerby 2014): −1 … 1; 0 if every
  /// difference is 0, NaN without differences.
  double rank_biserial = 0.0;
};

/// Tests whether the differences are distributed symmetrically about 0. Ties get mid-ranks. The
/// exact distribution is counted by dynamic programming over doubled ranks, in O(n³): a few
/// thousand pairs are feasible. With WilcoxonZeros::wilcox and ties the normal variance is
/// n(n+1)(2n+1)/24 − Σ(t³ − t)/48; in general it is a quarter of the sum of the squared ranks of
/// the differences that are not 0 or, with WilcoxonZeros::zsplit, as in SciPy, of all differences.
/// The exact distribution is conditional on ties and zeros, so that zsplit and pratt have the same
/// exact p. The differences must be finite.
Wilcoxon wilcoxon(const std::vector<double>& differences, WilcoxonMode mode = WilcoxonMode::exact,
                  WilcoxonZeros zeros = WilcoxonZeros::wilcox);

/// Location of paired differences: the median of the Walsh averages, which are the means of all
/// pairs of differences, including each difference with itself (Hodges and Lehmann 1963), with the
/// confidence interval of the signed-rank test (Tukey).
struct HodgesLehmann {
  double estimate = 0.0;
  double low = 0.0;
  double high = 0.0;
  /// Actual confidence of the interval; at least the requested one if attainable.
  double confidence = 0.0;
};

/// Differences of 0 count like any others. The ends of the interval are Walsh averages whose ranks
/// are determined by the exact distribution of W+ without ties or, above 300 differences, by its
/// normal approximation; ties make the interval conservative. With too few differences for the
/// confidence, it spans all Walsh averages. NaN without differences.
HodgesLehmann hodges_lehmann(const std::vector<double>& differences, double confidence = 0.95);

}  // namespace mien::pipeline
