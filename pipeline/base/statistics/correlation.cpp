#include "pipeline/base/statistics/correlation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace mien::pipeline {

namespace {

/// Sums of squares and products about the means of the complete pairs.
struct Moments {
  int pairs = 0;
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
};

Moments moments_of(const std::vector<double>& a, const std::vector<double>& b) {
  Moments moments;
  double mean_a = 0.0;
  double mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i])) continue;
    ++moments.pairs;
    mean_a += a[i];
    mean_b += b[i];
  }
  mean_a /= moments.pairs;
  mean_b /= moments.pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i])) continue;
    moments.aa += (a[i] - mean_a) * (a[i] - mean_a);
    moments.bb += (b[i] - mean_b) * (b[i] - mean_b);
    moments.ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return moments;
}

}  // namespace

Correlation pearson(const std::vector<double>& a, const std::vector<double>& b, double confidence) {
  assert(a.size() == b.size());
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const Moments moments = moments_of(a, b);
  Correlation result{moments.pairs, unknown, unknown, unknown, unknown, unknown};
  if (moments.pairs < 3 || moments.aa == 0.0 || moments.bb == 0.0) return result;
  result.r = std::clamp(moments.ab / std::sqrt(moments.aa * moments.bb), -1.0, 1.0);
  const double degrees = moments.pairs - 2.0;
  result.t = result.r * std::sqrt(degrees / (1.0 - result.r * result.r));
  result.p =
      std::isinf(result.t) ? 0.0 : 2.0 * cdf(boost::math::students_t(degrees), -std::abs(result.t));
  if (moments.pairs < 4) return result;
  const double reach =
      quantile(boost::math::normal(), 0.5 + 0.5 * confidence) / std::sqrt(moments.pairs - 3.0);
  result.low = std::tanh(std::atanh(result.r) - reach);
  result.high = std::tanh(std::atanh(result.r) + reach);
  return result;
}

}  // namespace mien::pipeline
