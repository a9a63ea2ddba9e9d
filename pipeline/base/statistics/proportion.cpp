#include "pipeline/base/statistics/proportion.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>

namespace mien::pipeline {

ShareInterval wilson(double successes, double trials, double confidence) {
  if (!(trials > 0.0)) return {};
  const double z = quantile(boost::math::normal(), 0.5 + 0.5 * confidence);
  const double share = successes / trials;
  const double weight = z * z / trials;
  const double middle = (share + 0.5 * weight) / (1.0 + weight);
  const double reach =
      z * std::sqrt(share * (1.0 - share) / trials + 0.25 * weight / trials) / (1.0 + weight);
  return {std::max(0.0, middle - reach), std::min(1.0, middle + reach)};
}

double binomial_test(int successes, int trials, double chance) {
  if (trials <= 0) return 1.0;
  const boost::math::binomial outcomes(trials, chance);
  // Outcomes that are as probable except for rounding errors count too, as in R.
  const double most = pdf(outcomes, successes) * (1.0 + 1e-7);
  double p = 0.0;
  for (int k = 0; k <= trials; ++k) {
    const double probability = pdf(outcomes, k);
    if (probability <= most) p += probability;
  }
  return std::min(1.0, p);
}

}  // namespace mien::pipeline
