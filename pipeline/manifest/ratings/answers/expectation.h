#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/answers/impressions.h"
#include "pipeline/manifest/ratings/scales/parameter_table.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The expectation that some examples are rated higher than others, by how they were acted: a
/// manipulation check.
struct Expectation {
  std::string parameter;           ///< a scale or a group
  std::vector<std::string> order;  ///< examples, from the low end to the high end; two or more
};

/// An example and where people put it.
struct PlacedExample {
  std::string example;
  double value = 0.0;  ///< 0 low end, 1 high end
};

/// How far one example lies above the one before it, by the people who rated both.
struct ExpectedStep {
  int people = 0;
  double difference = 0.0;  ///< mean over people, in shares of the range
  double low = 0.0;         ///< ends of its 95 % interval (paired t); NaN for fewer than two people
  double high = 0.0;

  /// Whether the step is up, and too large for noise.
  bool is_certain() const { return low > 0.0; }
};

/// What became of an expectation.
struct ExpectationCheck {
  std::string parameter;
  std::vector<PlacedExample> order;   ///< as expected
  std::vector<std::size_t> violated;  ///< i: example i + 1 is not above example i
  std::vector<ExpectedStep> steps;    ///< i: from example i to example i + 1

  bool holds() const { return violated.empty(); }
  /// Whether every step is more than noise.
  bool is_certain() const;
};

/// The examples of a study and what people said of them.
struct RatedExamples {
  const ParameterTable& parameters;
  const std::vector<RatedExample>& names;  ///< the table's columns
  const Answers& answers;
  const ScaleSet& scales;
};

/// Compares what is expected with what people said. Every parameter and example must be known.
std::vector<ExpectationCheck> check_expectations(const std::vector<Expectation>& expected,
                                                 const RatedExamples& examples);

/// "slow-fast: k-walk-slow 0.360 < k-walk-fast 0.530 (n = 14, +0.17, 95 % interval 0.10 to 0.24):
/// as expected", or what is not, or that it may be noise.
std::string sentence_of(const ExpectationCheck& check);

/// What each participant said of an example: participant → share of the scale's range, 0 low end,
/// 1 high end; of a group of scales the mean of those that the participant answered. Answers that
/// are means of several people are left out.
std::map<std::string, double> personal_values(const Answers& answers, const ScaleSet& scales,
                                              const RatedExample& example,
                                              const std::string& parameter);

}  // namespace mien::pipeline
