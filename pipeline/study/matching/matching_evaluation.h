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
  time_s,         ///< seconds, the limit for trials without success
};

/// "first_guess_d" or "time_s".
const char* name_of(MatchingMeasure measure);

/// Mean and standard deviation of a measure. Over all targets, values are participants' means; of
/// one target, trials.
struct MatchingMean {
  MatchingMeasure measure = MatchingMeasure::first_guess_d;
  std::string interface;
  std::string target;  ///< empty: all
  int n = 0;
  double mean = 0.0;
  double sd = 0.0;  ///< divided by n − 1; NaN for one value
};

/// Success of first guesses, and failures.
struct MatchingShare {
  std::string interface;
  std::string target;    ///< empty: all trials
  int guesses = 0;       ///< trials whose first guess has a D
  int near_guesses = 0;  ///< D below the threshold of the distance
  int trials = 0;
  int failures = 0;
};

/// A comparison of two interfaces by participants' differences, first − second: of one target, or
/// the mean over the targets matched with both. Arithmetic is exact for numbers with few decimals,
/// so that ties are detected. A difference of times is the time that the second interface saves.
struct MatchingComparison {
  MatchingMeasure measure = MatchingMeasure::first_guess_d;
  std::string target;  ///< empty: all
  std::string first;
  std::string second;
  TTest difference;  ///< t and p are NaN where all differences are the same
  Wilcoxon paper;    ///< normal approximation without continuity correction
  Wilcoxon exact;
  /// Corrected over the comparisons of the same measure: those of all targets by themselves, those
  /// of single ones together.
  double normal_holm = 1.0;
  double exact_holm = 1.0;
  double d_z = 0.0;
};

/// The evaluation of a matching experiment as in the adjective paper, section 4: target by target,
/// and over all. Five targets and three interfaces have the paper's 36 tests: three pairs, two
/// measures, five targets and all.
struct MatchingEvaluation {
  double threshold_m = 0.0;  ///< D below which motions match, metres
  std::vector<MatchingMean> means;
  std::vector<MatchingShare> shares;
  std::vector<std::string> targets;  ///< that there are results of by themselves; none of one alone
  std::vector<MatchingComparison> comparisons;  ///< every pair of interfaces, both measures
};

MatchingEvaluation evaluate(const MatchingResults& results);

}  // namespace mien::pipeline
