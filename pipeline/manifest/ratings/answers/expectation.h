#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/parameter_table.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The order of examples on a parameter that is expected because of how they were acted: a
/// manipulation check.
struct Expectation {
  std::string parameter;           ///< a scale or a group
  std::vector<std::string> order;  ///< examples, from the low end to the high end; two or more
};

/// An example and its mean rating.
struct PlacedExample {
  std::string example;
  double value = 0.0;  ///< 0 low end, 1 high end
};

/// The difference of an example from the preceding one, over the participants who rated both.
struct ExpectedStep {
  int people = 0;
  double difference = 0.0;  ///< mean over participants, as a share of the range
  double low = 0.0;  ///< lower end of the 95 % confidence interval (paired t); NaN for fewer than
                     ///< two participants
  double high = 0.0;

  /// Whether the step is significantly positive.
  bool is_certain() const { return low > 0.0; }
};

/// The result of checking an expectation.
struct ExpectationCheck {
  std::string parameter;
  std::vector<PlacedExample> order;  ///< in the expected order
  /// Indices i where example i + 1 is not rated above example i.
  std::vector<std::size_t> violated;
  std::vector<ExpectedStep> steps;  ///< element i: from example i to example i + 1

  bool holds() const { return violated.empty(); }
  /// Whether the expectation holds and every step is significantly positive.
  bool is_certain() const;
};

/// The examples of a study and their ratings.
struct RatedExamples {
  const ParameterTable& parameters;
  const std::vector<RatedExample>& names;  ///< the table's columns
  const Answers& answers;
  const ScaleSet& scales;
};

/// Compares expectations with the ratings. Every parameter and example must be known.
std::vector<ExpectationCheck> check_expectations(const std::vector<Expectation>& expected,
                                                 const RatedExamples& examples);

/// Returns a sentence with the result, which says whether the order is as expected, not as
/// expected, or in the expected direction but not significant (not tested if there are only means):
/// "slow-fast: k-walk-slow 0.360 < k-walk-fast 0.530 (n = 14, +0.17, 95 % interval 0.10 to 0.24):
/// as expected".
std::string sentence_of(const ExpectationCheck& check);

/// Returns each participant's rating of an example as a share of the scale's range: 0 low end, 1
/// high end. For a group of scales, it is the mean of those that the participant answered. Answers
/// that are means over several participants are ignored.
std::map<std::string, double> personal_values(const Answers& answers, const ScaleSet& scales,
                                              const RatedExample& example,
                                              const std::string& parameter);

}  // namespace mien::pipeline
