#include "pipeline/base/statistics/effect_size.h"

#include <cmath>
#include <limits>

#include <boost/math/special_functions/gamma.hpp>

#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

constexpr double no_effect_size = std::numeric_limits<double>::quiet_NaN();

/// Σ(x − x̄)², and the mean.
struct Deviation {
  double mean = 0.0;
  double squares = 0.0;
};

Deviation deviation_of(const std::vector<double>& values) {
  Deviation result;
  result.mean = exact_mean(values);
  for (const double value : values) result.squares += (value - result.mean) * (value - result.mean);
  return result;
}

}  // namespace

double cohens_d(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 2 || b.size() < 2) return no_effect_size;
  const Deviation of_a = deviation_of(a);
  const Deviation of_b = deviation_of(b);
  const double pooled =
      std::sqrt((of_a.squares + of_b.squares) / static_cast<double>(a.size() + b.size() - 2));
  return pooled > 0.0 ? (of_a.mean - of_b.mean) / pooled : no_effect_size;
}

double hedges_correction(double degrees) {
  if (degrees < 2.0) return no_effect_size;
  // Γ((ν − 1)/2)/Γ(ν/2)
  const double ratio = boost::math::tgamma_delta_ratio(0.5 * degrees - 0.5, 0.5);
  return 1.0 / (ratio * std::sqrt(0.5 * degrees));
}

double hedges_g(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 2 || b.size() < 2) return no_effect_size;
  return cohens_d(a, b) * hedges_correction(static_cast<double>(a.size() + b.size() - 2));
}

double hedges_gz(const std::vector<double>& differences) {
  if (differences.size() < 3) return no_effect_size;
  return cohens_dz(differences) * hedges_correction(static_cast<double>(differences.size() - 1));
}

}  // namespace mien::pipeline
