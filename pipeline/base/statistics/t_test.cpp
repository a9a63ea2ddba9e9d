#include "pipeline/base/statistics/t_test.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "pipeline/base/statistics/exact_number.h"

namespace mien::pipeline {

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

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

/// Variance (n − 1); exactly 0 if values differ by rounding errors only.
double variance_of(const std::vector<double>& values) {
  if (all_equal(values)) return 0.0;
  return deviation_of(values).squares / static_cast<double>(values.size() - 1);
}

TTest finished(TTest test) {
  test.t = test.mean / test.standard_error;
  if (std::isnan(test.t)) return test;  // nothing differs
  test.p = std::isinf(test.t) ? 0.0
                              : 2.0 * cdf(boost::math::students_t(test.degrees), -std::abs(test.t));
  return test;
}

double margin(const TTest& test, double confidence) {
  if (!(test.degrees > 0.0)) return not_known;
  return quantile(boost::math::students_t(test.degrees), 0.5 + 0.5 * confidence) *
         test.standard_error;
}

/// Factor that removes the bias of d: Γ(ν/2)/(√(ν/2)·Γ((ν − 1)/2)) (Hedges 1981) with ν degrees of
/// freedom: n + m − 2 for two samples, n − 1 for differences. NaN for ν below two.
double hedges_correction(double degrees) {
  if (degrees < 2.0) return not_known;
  // Γ((ν − 1)/2)/Γ(ν/2)
  const double ratio = boost::math::tgamma_delta_ratio(0.5 * degrees - 0.5, 0.5);
  return 1.0 / (ratio * std::sqrt(0.5 * degrees));
}

}  // namespace

double TTest::low(double confidence) const { return mean - margin(*this, confidence); }
double TTest::high(double confidence) const { return mean + margin(*this, confidence); }

bool all_equal(const std::vector<double>& values) {
  if (values.empty()) return true;
  const auto [least, most] = std::ranges::minmax(values);
  return most - least <= 1e-12 * std::max({1.0, std::abs(least), std::abs(most)});
}

TTest paired_t_test(const std::vector<double>& differences) {
  if (differences.size() < 2)
    return {differences.empty() ? not_known : differences[0], not_known, 0.0, not_known, not_known};
  const auto n = static_cast<double>(differences.size());
  return finished({exact_mean(differences), std::sqrt(variance_of(differences) / n), n - 1.0});
}

TTest welch_t_test(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 2 || b.size() < 2) return {not_known, not_known, 0.0, not_known, not_known};
  const auto n = static_cast<double>(a.size());
  const auto m = static_cast<double>(b.size());
  const double of_a = variance_of(a) / n;
  const double of_b = variance_of(b) / m;
  const double both = of_a + of_b;
  const double degrees =
      both > 0.0 ? both * both / (of_a * of_a / (n - 1.0) + of_b * of_b / (m - 1.0)) : n + m - 2.0;
  return finished({exact_mean(a) - exact_mean(b), std::sqrt(both), degrees});
}

double cohens_dz(const std::vector<double>& differences) {
  if (differences.size() < 2) return not_known;
  return exact_mean(differences) / std::sqrt(variance_of(differences));
}

double cohens_d(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 2 || b.size() < 2) return not_known;
  const Deviation of_a = deviation_of(a);
  const Deviation of_b = deviation_of(b);
  const double pooled =
      std::sqrt((of_a.squares + of_b.squares) / static_cast<double>(a.size() + b.size() - 2));
  return pooled > 0.0 ? (of_a.mean - of_b.mean) / pooled : not_known;
}

double hedges_g(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 2 || b.size() < 2) return not_known;
  return cohens_d(a, b) * hedges_correction(static_cast<double>(a.size() + b.size() - 2));
}

double hedges_gz(const std::vector<double>& differences) {
  if (differences.size() < 3) return not_known;
  return cohens_dz(differences) * hedges_correction(static_cast<double>(differences.size() - 1));
}

}  // namespace mien::pipeline
