#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/adaptive/interval_ends.h"

namespace mien::pipeline {

/// The values of one dimension, a list for each chain, all of the same length.
using ChainValues = std::vector<std::vector<double>>;

/// The values of a dimension at the end of each complete sweep of `steps_per_sweep` steps, without
/// the first `discarded` sweeps. `paths` has each chain's points after its steps. All chains are
/// cut to the length of the shortest.
ChainValues chain_values(const std::vector<std::vector<std::vector<double>>>& paths,
                         std::size_t dimension, std::size_t steps_per_sweep, std::size_t discarded);

/// The number of complete sweeps of the shortest chain.
std::size_t shortest_sweeps(const std::vector<std::vector<std::vector<double>>>& paths,
                            std::size_t steps_per_sweep);

/// The potential scale reduction factor (Gelman and Rubin 1992)
///
///   R̂ = √(((n − 1)/n · W + B/n)/W)
///
/// of chains of n values, with W the mean of the variances within chains and B/n the variance of
/// the chains' means (both with one less than the number in the denominator). Near 1 if chains
/// agree; above 1.1 they have not converged to the same distribution. It may be slightly below 1.
/// NaN with fewer than two chains or values, and if no value differs from another; infinite if
/// values differ between chains only.
double scale_reduction(const ChainValues& chains);

/// Whether R̂ shows that chains do not agree: above 1.1, and larger than it would be for chains of
/// independent values of one normal distribution with a probability of 0.001. With few values per
/// chain, R̂ is often above 1.1 by chance.
bool are_different(const ChainValues& chains);

/// Whether chains agree so well that they may end: R̂ of the second halves of their sweeps is at
/// most `r_hat` in every dimension. Chains in which no value differs from another agree. `paths`
/// and `steps_per_sweep` as for chain_values; false with fewer than two values in the second
/// halves.
bool have_converged(const std::vector<std::vector<std::vector<double>>>& paths,
                    std::size_t steps_per_sweep, double r_hat);

/// The number of independent values that would determine the mean as well as these (Gelman and
/// others 2013, section 11.5): m·n/(1 + 2·Σρ), with the autocorrelations ρ estimated from all m
/// chains, and summed from the first until the sum of the next two is negative. At most m·n.
/// NaN where scale_reduction is not finite.
double effective_sample_size(const ChainValues& chains);

/// The mean of all values, with an interval from the means of the chains by the t distribution. It
/// needs no model of the dependence within chains, as chains are independent of each other.
struct ChainMean {
  double mean;
  IntervalEnds ends;  ///< NaN with fewer than two chains
};

ChainMean chain_mean(const ChainValues& chains, double confidence = 0.95);

}  // namespace mien::pipeline
