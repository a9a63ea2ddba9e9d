#include "pipeline/base/statistics/signal_detection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

namespace mien::pipeline {

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr Sensitivity no_sensitivity = {
    nan_value, nan_value, {nan_value, nan_value}, nan_value, {nan_value, nan_value}};

/// Sensitivities beyond this cannot be told from it by any count of answers.
constexpr double most_d = 20.0;

double z_of(double share) { return quantile(boost::math::normal(), share); }
double density_at(double z) { return pdf(boost::math::normal(), z); }
double below(double z) { return cdf(boost::math::normal(), z); }

bool has_both(const DetectionCounts& counts) {
  return counts.signal_trials > 0 && counts.noise_trials > 0;
}

/// Variance of z of a rate, by the delta method.
double variance_of_z(double rate, int trials) {
  const double density = density_at(z_of(rate));
  return rate * (1.0 - rate) / (trials * density * density);
}

Interval95 around(double value, double error) {
  const double reach = z_of(0.975) * error;
  return {value - reach, value + reach};
}

double false_alarm_rate(double k) { return 2.0 * below(-k / std::numbers::sqrt2); }

double hit_rate(double d, double k) {
  return below((d - k) / std::numbers::sqrt2) + below((-d - k) / std::numbers::sqrt2);
}

double log_likelihood_of(double rate, double count, double trials) {
  constexpr double least = 1e-300;
  return count * std::log(std::max(rate, least)) +
         (trials - count) * std::log(std::max(1.0 - rate, least));
}

/// The likelihood of the differencing model for corrected counts.
class DifferencingLikelihood {
 public:
  explicit DifferencingLikelihood(const DetectionCounts& counts)
      : hits_(counts.hits + 0.5),
        signals_(counts.signal_trials + 1.0),
        alarms_(counts.false_alarms + 0.5),
        noises_(counts.noise_trials + 1.0) {}

  /// k with the greatest likelihood for that d.
  double best_k(double d) const {
    constexpr int bits = 26;
    return boost::math::tools::brent_find_minima([&](double k) { return -at(d, k); }, 0.0,
                                                 d + most_d, bits)
        .first;
  }

  /// The logarithm of the profile likelihood of d.
  double of(double d) const { return at(d, best_k(d)); }

 private:
  double at(double d, double k) const {
    return log_likelihood_of(hit_rate(d, k), hits_, signals_) +
           log_likelihood_of(false_alarm_rate(k), alarms_, noises_);
  }

  double hits_, signals_, alarms_, noises_;
};

/// Where a function that has different signs at the ends is 0.
double root_between(auto&& function, double low, double high) {
  constexpr int bits = 40;
  std::uintmax_t steps = 200;
  const auto [from, to] = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(bits), steps);
  return 0.5 * (from + to);
}

}  // namespace

DetectionRates log_linear_rates(const DetectionCounts& counts) {
  return {(counts.hits + 0.5) / (counts.signal_trials + 1.0),
          (counts.false_alarms + 0.5) / (counts.noise_trials + 1.0)};
}

double yes_no_d(const DetectionRates& rates) { return z_of(rates.hit) - z_of(rates.false_alarm); }

Sensitivity yes_no_sensitivity(const DetectionCounts& counts) {
  if (!has_both(counts)) return no_sensitivity;
  const DetectionRates rates = log_linear_rates(counts);
  const auto [hit, false_alarm] = rates;
  const double error = std::sqrt(variance_of_z(hit, counts.signal_trials) +
                                 variance_of_z(false_alarm, counts.noise_trials));
  const double d = yes_no_d(rates);
  const double criterion = -0.5 * (z_of(hit) + z_of(false_alarm));
  return {d, error, around(d, error), criterion, around(criterion, 0.5 * error)};
}

Sensitivity two_interval_sensitivity(const DetectionCounts& counts) {
  Sensitivity result = yes_no_sensitivity(counts);
  result.d /= std::numbers::sqrt2;
  result.error /= std::numbers::sqrt2;
  result.d_ends = around(result.d, result.error);
  return result;
}

double differencing_d(const DetectionRates& rates) {
  if (rates.hit <= rates.false_alarm) return 0.0;
  const double k = -std::numbers::sqrt2 * z_of(0.5 * rates.false_alarm);
  double high = 1.0;
  while (hit_rate(high, k) < rates.hit && high < 100.0) high *= 2.0;
  return root_between([&](double d) { return hit_rate(d, k) - rates.hit; }, 0.0, high);
}

Sensitivity same_different_sensitivity(const DetectionCounts& counts) {
  if (!has_both(counts)) return no_sensitivity;
  Sensitivity result = no_sensitivity;
  result.d = differencing_d(log_linear_rates(counts));
  const DifferencingLikelihood likelihood(counts);
  result.criterion = likelihood.best_k(result.d);
  // The 95 % quantile of χ² with one degree of freedom is 3.84.
  const double least = likelihood.of(result.d) - 0.5 * std::pow(z_of(0.975), 2.0);
  const auto excess = [&](double d) { return likelihood.of(d) - least; };
  result.d_ends.low = excess(0.0) >= 0.0 ? 0.0 : root_between(excess, 0.0, result.d);
  result.d_ends.high = excess(most_d) >= 0.0 ? most_d : root_between(excess, result.d, most_d);
  return result;
}

}  // namespace mien::pipeline
