#pragma once

#include <vector>

namespace mien::pipeline {

/// Which two-sided p value.
enum class WilcoxonMode {
  exact,      ///< the distribution of W+ over all signs of the ranks at hand, ties included
  published,  ///< normal, no continuity correction: what the adjective paper's p values are
  corrected,  ///< normal, with continuity correction, as R's wilcox.test(exact = FALSE)
};

/// What becomes of differences that are 0.
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
  double w_minus = 0.0;        ///< likewise, negative
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
