#include "pipeline/base/statistics/noncentral_interval.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/tools/roots.hpp>

namespace mien::pipeline {

namespace {

constexpr double no_interval = std::numeric_limits<double>::quiet_NaN();

/// Where a falling function has its root. `low` is not above the root; `step` is a first guess at
/// the distance of the other end.
double root_of_falling(auto&& function, double low, double step) {
  double high = low + step;
  while (function(high) > 0.0) {
    low = high;
    step *= 2.0;
    high += step;
  }
  constexpr int bits = 48;
  std::uintmax_t steps = 200;
  const auto [from, to] = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(bits), steps);
  return 0.5 * (from + to);
}

/// Noncentralities (t², or F times its degrees of freedom) above which the effect's own spread,
/// below 0.07 % of them, is nothing beside that of the error, and the series of Boost are slow and
/// fail.
constexpr double overwhelming = 1e7;

/// The factor by which an error of that many degrees of freedom is exceeded with the probability
/// `below`, as a variance.
double error_exceeded(double error_degrees, double below) {
  return quantile(complement(boost::math::chi_squared(error_degrees), below)) / error_degrees;
}

/// The noncentrality for which F has the probability `below` of a smaller value; 0 if there is
/// none.
double noncentrality_of_f(double f, double degrees, double error_degrees, double below) {
  if (f * degrees > overwhelming) return f * degrees * error_exceeded(error_degrees, below);
  if (cdf(boost::math::fisher_f(degrees, error_degrees), f) <= below) return 0.0;
  return root_of_falling(
      [&](double noncentrality) {
        if (noncentrality == 0.0)
          return cdf(boost::math::fisher_f(degrees, error_degrees), f) - below;
        return cdf(boost::math::non_central_f(degrees, error_degrees, noncentrality), f) - below;
      },
      0.0, 1.0 + degrees * f);
}

/// The same for t, whose noncentrality may be negative.
double noncentrality_of_t(double t, double degrees, double below) {
  if (t * t > overwhelming)
    return t * std::sqrt(error_exceeded(degrees, t > 0.0 ? below : 1.0 - below));
  const auto excess = [&](double noncentrality) {
    return cdf(boost::math::non_central_t(degrees, noncentrality), t) - below;
  };
  double low = t;
  for (double step = 1.0; excess(low) < 0.0; step *= 2.0) low = t - step;
  return root_of_falling(excess, low, 1.0);
}

}  // namespace

EffectInterval partial_eta_interval(double f, double degrees, double error_degrees,
                                    double confidence) {
  if (!std::isfinite(f) || f < 0.0) return {no_interval, no_interval};
  const double tail = 0.5 * (1.0 - confidence);
  const auto share_of = [&](double noncentrality) {
    return noncentrality / (noncentrality + degrees + error_degrees + 1.0);
  };
  return {share_of(noncentrality_of_f(f, degrees, error_degrees, 1.0 - tail)),
          share_of(noncentrality_of_f(f, degrees, error_degrees, tail))};
}

EffectInterval cohens_dz_interval(double t, int pairs, double confidence) {
  if (!std::isfinite(t) || pairs < 2) return {no_interval, no_interval};
  const double tail = 0.5 * (1.0 - confidence);
  const double root = std::sqrt(static_cast<double>(pairs));
  return {noncentrality_of_t(t, pairs - 1.0, 1.0 - tail) / root,
          noncentrality_of_t(t, pairs - 1.0, tail) / root};
}

}  // namespace mien::pipeline
