#pragma once

#include <string>
#include <vector>

#include "pipeline/base/statistics/worth_bootstrap.h"
#include "pipeline/study/results/compared_conditions.h"
#include "pipeline/study/results/factor_contrasts.h"

namespace mien::pipeline {

/// A difference between log-worths: a planned contrast, or two stimuli or conditions.
struct WorthContrast {
  ContrastKind kind = ContrastKind::planned;
  std::string name;                   ///< of a pair: "acted, matched − acted, mismatched"
  std::string weights;                ///< "matched − mismatched"; of a pair the same as the name
  std::vector<std::string> settings;  ///< as in FactorContrast; none for a pair
  WorthWeights of;                    ///< weight of each condition
  double difference;  ///< in log-worth; NaN if some of the worths are not comparable
  Interval95 ends;    ///< 95 % interval
  double error;       ///< standard error
  double statistic;   ///< difference / error
  /// Degrees of freedom of Student's distribution; NaN (a normal distribution) if all answers are
  /// treated as independent.
  double degrees;
  double p;
  double adjusted = 1.0;  ///< p adjusted over all contrasts of this kind for all items
};

/// With more stimuli or conditions, only planned contrasts are computed.
inline constexpr std::size_t most_compared_in_pairs = 20;

/// The planned contrasts for this item, then all pairs of `compared` (indices of conditions), all
/// without numbers. Their weights are in the order of `compared`.
std::vector<WorthContrast> begun_worth_contrasts(const AnswerSet& answer_set,
                                                 const ComparedConditions& conditions,
                                                 const std::vector<std::size_t>& compared,
                                                 const std::string& item);

/// Sets difference, interval and p from the standard error: treats all answers as independent.
void set_by_answers(WorthContrast& contrast, double difference, double error);

/// Sets difference, interval and p from resampled participants: the interval consists of their
/// percentiles, and p is from Student's distribution with people − 1 degrees of freedom.
void set_by_participants(WorthContrast& contrast, double difference,
                         const ResampledContrast& resampled, int people);

}  // namespace mien::pipeline
