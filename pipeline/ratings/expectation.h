#pragma once

#include <string>
#include <vector>

#include "pipeline/ratings/impressions.h"

namespace mien::pipeline {

/// That people should have rated some examples higher than others, by the way they were acted: a
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

/// What became of an expectation.
struct ExpectationCheck {
  std::string parameter;
  std::vector<PlacedExample> order;   ///< as expected
  std::vector<std::size_t> violated;  ///< i: example i + 1 is not above example i

  bool holds() const { return violated.empty(); }
};

/// Compares what is expected with what people said. Every parameter and example must be known.
std::vector<ExpectationCheck> check_expectations(const std::vector<Expectation>& expected,
                                                 const ParameterTable& parameters,
                                                 const std::vector<std::string>& examples);

/// "k-walk-slow 0.36 < k-walk-fast 0.53 on slow-fast: as expected", or what is not.
std::string sentence_of(const ExpectationCheck& check);

}  // namespace mien::pipeline
