#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/statistics/pair_counts.h"

namespace mien::pipeline {

/// What comparisons say about the log-worths λ of the model of Bradley and Terry (1952), in which
/// stimulus i is chosen over j with probability 1 / (1 + exp(λ_j − λ_i)), if each λ has a normal
/// prior with mean 0: the normal distribution at the maximum of the posterior (Laplace's
/// approximation). In contrast to maximum likelihood it exists for any comparisons, also none.
struct PairPosterior {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double prior = 1.0;         ///< standard deviation of each λ before any comparison
  double log_evidence = 0.0;  ///< log probability of the comparisons, by Laplace's approximation

  /// Sum over the stimuli of the variances of the worths about their mean.
  double variance() const;
  /// The square root of their mean.
  double deviation() const;
};

/// The posterior of the worths of `stimuli` stimuli with a prior of this standard deviation. A tie
/// counts as half a choice of each; all comparisons are treated as independent, and an effect of
/// order is not modelled: it cancels if each stimulus is first as often as second.
PairPosterior pair_posterior_with(const std::vector<PairCount>& counts, std::size_t stimuli,
                                  double prior);

/// The posterior with the most probable prior, to within 10 %: the maximum of the evidence times a
/// log-normal prior of the standard deviation (median 1, of its logarithm 0.7). With a fixed prior
/// that is wider than the worths, chance differences of early comparisons would be taken for real,
/// and such pairs would not be asked again.
PairPosterior pair_posterior(const std::vector<PairCount>& counts, std::size_t stimuli);

/// What one more comparison of two stimuli is expected to be.
struct ExpectedComparison {
  double first_chosen = 0.5;  ///< probability that the first is chosen
  double curvature = 0.0;     ///< expected Fisher information about the difference of worths
};

ExpectedComparison expected_comparison(const PairPosterior& posterior, std::size_t first,
                                       std::size_t second);

/// By how much PairPosterior::variance would fall if `answers` comparisons of two stimuli came out
/// as expected.
double expected_gain(const PairPosterior& posterior, std::size_t first, std::size_t second,
                     double answers);

/// Updates the posterior as if `answers` comparisons had come out as expected: means stay, and
/// variances fall by the expected curvature.
void expect_answers(PairPosterior& posterior, std::size_t first, std::size_t second,
                    double answers);

}  // namespace mien::pipeline
