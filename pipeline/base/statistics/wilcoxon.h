#pragma once

#include <vector>

namespace mien::pipeline {

/// Method for the two-sided p value.
enum class WilcoxonMode {
  exact,      ///< the distribution of W+ over all signs of the ranks at hand, ties included
  published,  ///< normal, no continuity correction, as in the adjective paper
  corrected,  ///< normal, with continuity correction, as R's wilcox.test(exact = FALSE)
};

/// Treatment of differences of 0.
enum class WilcoxonZeros {
  wilcox,  ///< left out before ranking (Wilcoxon 1945)
  pratt,   ///< ranked with the others, then left out (Pratt 1959)
  zsplit,  ///< ranked with the others, half of their ranks on either side
};

/// The signed-rank test of paired differences.
struct Wilcoxon {
  int pairs = 0;               ///< all differences
  int used = 0;                ///< those that are not 0
  int zeros = 0;               ///< those that are
  int tied = 0;                ///< ranked differences that share their size with another
  double w_plus = 0.0;         ///< sum of the mid-ranks of the positive differences: the V of R
  double w_minus = 0.0;        ///< sum of the mid-ranks of the negative differences
  double z = 0.0;              ///< of the normal modes; 0 for exact
  double p = 1.0;              ///< two-sided; 1 when every difference is 0
  double rank_biserial = 0.0;  ///< (W+ − W−)/(W+ + W−), matched pairs (Kerby 2014): −1 … 1
};

/// Tests whether the differences lie about 0. Mid-ranks for ties. The exact distribution is
/// counted by dynamic programming over doubled ranks, in O(n³): some thousands of pairs are fine.
/// With zeros::wilcox and ties the normal variance is n(n+1)(2n+1)/24 − Σ(t³ − t)/48; generally a
/// quarter of the sum of the squared ranks of what is not 0; with zeros::zsplit, as in SciPy, of
/// all ranks. The exact distribution is conditional on ties and zeros: zsplit then has the p of
/// Pratt. The differences must be finite.
Wilcoxon wilcoxon(const std::vector<double>& differences, WilcoxonMode mode = WilcoxonMode::exact,
                  WilcoxonZeros zeros = WilcoxonZeros::wilcox);

/// Location of paired differences: the median of the Walsh averages, that is, the means of all
/// pairs including each difference with itself (Hodges and Lehmann 1963), with the confidence
/// interval of the signed-rank test (Tukey).
struct HodgesLehmann {
  double estimate = 0.0;
  double low = 0.0;
  double high = 0.0;
  double confidence =
      0.0;  ///< actual confidence of the interval; at least the requested one if attainable
};

/// Differences of 0 count like any others. The ends are Walsh averages whose ranks come from the
/// exact distribution of W+ without ties or, above 300 differences, from its normal approximation;
/// ties make the interval conservative. With too few differences for the confidence, it spans all
/// Walsh averages. NaN without differences.
HodgesLehmann hodges_lehmann(const std::vector<double>& differences, double confidence = 0.95);

}  // namespace mien::pipeline
