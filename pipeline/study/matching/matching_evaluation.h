#pragma once

#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/base/statistics/wilcoxon.h"
#include "pipeline/study/matching/matching_results.h"

namespace mien::pipeline {

/// A dependent measure of a matching trial.
enum class MatchingMeasure {
  first_guess_d,  ///< metres
  time_s,         ///< seconds; trials without success count with the time limit
};

/// "first_guess_d" or "time_s".
const char* name_of(MatchingMeasure measure);

/// Mean and standard deviation of a measure: over participants' means if all targets are included,
/// over trials for a single target. Units are those of the measure.
struct MatchingMean {
  MatchingMeasure measure = MatchingMeasure::first_guess_d;
  std::string interface;
  std::string target;  ///< empty: all
  int n = 0;           ///< number of participants or trials
  double mean = 0.0;
  double sd = 0.0;  ///< with divisor n − 1; NaN for one value
};

/// Counts of successful first guesses and of failures.
struct MatchingShare {
  std::string interface;
  std::string target;    ///< empty: all
  int guesses = 0;       ///< trials whose first guess has a known D
  int near_guesses = 0;  ///< first guesses with D below the threshold
  int trials = 0;
  int failures = 0;  ///< trials without a match
};

/// A comparison of two interfaces by the differences first − second of each participant, for one
/// target, or averaged over the targets for which the participant has a value with both interfaces.
/// Arithmetic is exact for numbers with few decimals, so that ties are detected. A difference of
/// times is the time that the second interface saves.
struct MatchingComparison {
  MatchingMeasure measure = MatchingMeasure::first_guess_d;
  std::string target;  ///< empty: all
  std::string first;
  std::string second;
  TTest difference;  ///< t and p are NaN if all differences are equal
  /// As in the adjective paper: by normal approximation without continuity correction.
  Wilcoxon paper;
  Wilcoxon exact;
  /// p values of `paper` and `exact`, adjusted by Holm's method over the comparisons of the same
  /// measure. Comparisons over all targets and those of single targets are adjusted separately.
  double normal_holm = 1.0;
  double exact_holm = 1.0;
  double d_z = 0.0;  ///< Cohen's d of the differences; NaN if all are equal
};

/// The evaluation of a matching experiment as in the adjective paper, section 4, for each target
/// and over all. Five targets and three interfaces result in the paper's 36 tests: three pairs of
/// interfaces × two measures × (five targets + all).
struct MatchingEvaluation {
  double threshold_m = 0.0;  ///< D below which motions match, metres
  std::vector<MatchingMean> means;
  std::vector<MatchingShare> shares;
  std::vector<std::string> targets;  ///< targets evaluated singly; empty if there is only one
  /// For every pair of interfaces and both measures, over all targets and for each of `targets`;
  /// without those for which no participant has values with both interfaces.
  std::vector<MatchingComparison> comparisons;
};

MatchingEvaluation evaluate(const MatchingResults& results);

}  // namespace mien::pipeline
