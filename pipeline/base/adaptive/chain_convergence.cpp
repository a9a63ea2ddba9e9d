#include "pipeline/base/adaptive/chain_convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace mien::pipeline {

namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// With n − 1 in the denominator: NaN for a single value.
double variance_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / static_cast<double>(values.size() - 1);
}

std::vector<double> means_of(const ChainValues& chains) {
  std::vector<double> means;
  for (const std::vector<double>& chain : chains) means.push_back(mean_of(chain));
  return means;
}

double within_variance(const ChainValues& chains) {
  std::vector<double> variances;
  for (const std::vector<double>& chain : chains) variances.push_back(variance_of(chain));
  return mean_of(variances);
}

/// Estimate of the variance of the distribution that chains of n values have in common.
double common_variance(const ChainValues& chains) {
  const auto n = static_cast<double>(chains.front().size());
  return (n - 1.0) / n * within_variance(chains) + variance_of(means_of(chains));
}

/// The mean squared difference of values at this distance within chains.
double variogram(const ChainValues& chains, std::size_t lag) {
  double squares = 0.0;
  std::size_t count = 0;
  for (const std::vector<double>& chain : chains)
    for (std::size_t i = lag; i < chain.size(); ++i, ++count)
      squares += (chain[i] - chain[i - lag]) * (chain[i] - chain[i - lag]);
  return squares / static_cast<double>(count);
}

}  // namespace

std::size_t shortest_sweeps(const std::vector<std::vector<std::vector<double>>>& paths,
                            std::size_t steps_per_sweep) {
  std::size_t sweeps = std::numeric_limits<std::size_t>::max();
  for (const auto& path : paths) sweeps = std::min(sweeps, path.size() / steps_per_sweep);
  return paths.empty() ? 0 : sweeps;
}

ChainValues chain_values(const std::vector<std::vector<std::vector<double>>>& paths,
                         std::size_t dimension, std::size_t steps_per_sweep,
                         std::size_t discarded) {
  const std::size_t sweeps = shortest_sweeps(paths, steps_per_sweep);
  ChainValues chains;
  for (const auto& path : paths) {
    std::vector<double>& values = chains.emplace_back();
    for (std::size_t sweep = discarded; sweep < sweeps; ++sweep)
      values.push_back(path[(sweep + 1) * steps_per_sweep - 1][dimension]);
  }
  return chains;
}

double scale_reduction(const ChainValues& chains) {
  if (chains.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(common_variance(chains) / within_variance(chains));
}

bool are_different(const ChainValues& chains) {
  constexpr double usual_bound = 1.1;
  constexpr double chance = 0.001;
  const double r_hat = scale_reduction(chains);
  if (!(r_hat > usual_bound)) return false;
  if (!std::isfinite(r_hat)) return true;
  const auto m = static_cast<double>(chains.size());
  const auto n = static_cast<double>(chains.front().size());
  const boost::math::fisher_f ratio(m - 1.0, m * (n - 1.0));
  return cdf(complement(ratio, n * r_hat * r_hat - (n - 1.0))) < chance;
}

bool have_converged(const std::vector<std::vector<std::vector<double>>>& paths,
                    std::size_t steps_per_sweep, double r_hat) {
  const std::size_t sweeps = shortest_sweeps(paths, steps_per_sweep);
  if (sweeps - sweeps / 2 < 2) return false;
  const std::size_t dimensions = paths.front().front().size();
  for (std::size_t d = 0; d < dimensions; ++d)
    if (scale_reduction(chain_values(paths, d, steps_per_sweep, sweeps / 2)) > r_hat) return false;
  return true;
}

double effective_sample_size(const ChainValues& chains) {
  if (!std::isfinite(scale_reduction(chains))) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t n = chains.front().size();
  const double all = static_cast<double>(chains.size() * n);
  const double variance = common_variance(chains);
  const auto correlation = [&](std::size_t lag) {
    return 1.0 - variogram(chains, lag) / (2.0 * variance);
  };
  double sum = correlation(1);
  for (std::size_t lag = 2; lag + 1 < n; lag += 2) {
    const double pair = correlation(lag) + correlation(lag + 1);
    if (pair < 0.0) break;
    sum += pair;
  }
  // Values that alternate would count for more than they are, without bound.
  return all / std::max(1.0, 1.0 + 2.0 * sum);
}

ChainMean chain_mean(const ChainValues& chains, double confidence) {
  const std::vector<double> means = means_of(chains);
  const double mean = mean_of(means);
  if (means.size() < 2) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {mean, {unknown, unknown}};
  }
  const auto count = static_cast<double>(means.size());
  const double t = quantile(boost::math::students_t(count - 1.0), 0.5 * (1.0 + confidence));
  const double reach = t * std::sqrt(variance_of(means) / count);
  return {mean, {mean - reach, mean + reach}};
}

}  // namespace mien::pipeline
