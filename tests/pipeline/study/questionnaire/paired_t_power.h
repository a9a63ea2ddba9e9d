#pragma once

#include <cmath>

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace mien::test {

/// Power of the two-sided paired t test of so many differences of this mean and standard deviation,
/// by the noncentral t distribution.
inline double paired_t_power(int pairs, double mean, double deviation, double alpha) {
  const boost::math::students_t usual(pairs - 1.0);
  const double critical = quantile(complement(usual, alpha / 2.0));
  const boost::math::non_central_t test(pairs - 1.0, mean / deviation * std::sqrt(pairs));
  return cdf(complement(test, critical)) + cdf(test, -critical);
}

}  // namespace mien::test
