#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/pair_counts.h"

namespace mien::pipeline {

/// A 95 % confidence interval; NaN where there is none.
struct Interval95 {
  double low;
  double high;
};

/// Whether the model has an advantage of the stimulus that is shown first.
enum class OrderEffect { none, estimated };

/// Worths of stimuli on a common scale, by the model of Bradley and Terry (1952) with ties
/// (Davidson 1970) and an order effect (Davidson and Beaver 1977). With the log-worths λ, the
/// outcomes of a comparison of i, shown first, with j are
///
///     P(i) ∝ exp(λ_i + δ/2),   P(j) ∝ exp(λ_j − δ/2),   P(tie) ∝ exp(η + (λ_i + λ_j)/2),
///
/// without the third term if there are no ties at all. A difference of 1 in log-worth means that
/// the odds of being chosen are e : 1 if neither is favoured by its place. In the notation of
/// Davidson and Beaver θ = exp(−δ), and their ν is exp(η − δ/2): here, exchanging first and second
/// in all comparisons changes the sign of δ and nothing else.
struct BradleyTerry {
  WinGroups groups;
  /// Whether the likelihood has a maximum: order effect, ties and the differences within groups are
  /// finite and determined. Otherwise all numbers below are NaN. It has none, for example, if the
  /// first stimulus was chosen in all comparisons, if all comparisons are ties, or if an order
  /// effect cannot be distinguished from differences in worth.
  bool is_finite = false;
  /// λ of each stimulus; sums to zero within each group. NaN for a stimulus that is a group of its
  /// own.
  std::vector<double> worth;
  std::vector<double> error;  ///< standard errors, from the information matrix
  double order;  ///< δ: log-odds in favour of the first stimulus; NaN if not in the model
  double order_error;
  double tie;  ///< η: P(tie) = exp(η)·√(P(i)·P(j)); NaN if there were no ties
  double tie_error;
  /// Σ log P of all outcomes. Those between groups contribute 0, the limit for an infinite
  /// difference.
  double log_likelihood;
};

/// Estimates the worths by maximum likelihood with Newton's method, which ends when no parameter
/// changes by more than 1e-9; as the steps decrease quadratically, the error is smaller. Outcomes
/// between groups say nothing about finite differences and are left out, which is the limit of the
/// likelihood. Numbers of comparisons must be finite and not negative, and stimuli below `stimuli`.
BradleyTerry bradley_terry(const std::vector<PairCount>& counts, std::size_t stimuli,
                           OrderEffect order);

/// 95 % intervals of the worths by profile likelihood (Venzon and Moolgavkar 1988): all values that
/// the likelihood-ratio test does not reject. All comparisons are treated as independent. `fit` is
/// the result of bradley_terry for these counts.
std::vector<Interval95> profile_intervals(const BradleyTerry& fit,
                                          const std::vector<PairCount>& counts, OrderEffect order);

/// Standard errors of sums of worths times weights, from the information matrix; all comparisons
/// are treated as independent. The weights, one for each stimulus, must be of stimuli of the same
/// group and have a sum of 0. NaN if the model has no finite estimate.
std::vector<double> contrast_errors(const BradleyTerry& fit, const std::vector<PairCount>& counts,
                                    OrderEffect order,
                                    const std::vector<std::vector<double>>& contrasts);

/// A likelihood-ratio test. p is NaN if one of the models has no finite estimate or there are no
/// degrees of freedom.
struct LikelihoodRatio {
  double chi;       ///< 2·(difference of the log-likelihoods)
  int degrees = 0;  ///< degrees of freedom of the χ² distribution
  double p;
};

/// Tests whether all worths are equal, in the model with or without order effect. Degrees of
/// freedom: number of compared stimuli less the number of parts (WinGroups). All comparisons are
/// treated as independent.
LikelihoodRatio equal_worth_test(const BradleyTerry& fit, const std::vector<PairCount>& counts,
                                 OrderEffect order);

/// Tests whether there is an order effect: the model with it against that without it.
LikelihoodRatio order_test(const BradleyTerry& with_order, const BradleyTerry& without_order);

}  // namespace mien::pipeline
