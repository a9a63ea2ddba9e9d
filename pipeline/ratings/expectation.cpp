#include "pipeline/ratings/expectation.h"

#include <algorithm>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

Eigen::Index column_of(const std::vector<std::string>& examples, const std::string& name) {
  return std::find(examples.begin(), examples.end(), name) - examples.begin();
}

}  // namespace

std::vector<ExpectationCheck> check_expectations(const std::vector<Expectation>& expected,
                                                 const ParameterTable& parameters,
                                                 const std::vector<std::string>& examples) {
  std::vector<ExpectationCheck> checks;
  for (const Expectation& expectation : expected) {
    ExpectationCheck check;
    check.parameter = expectation.parameter;
    const int row = parameters.find(expectation.parameter);
    for (const std::string& example : expectation.order) {
      check.order.push_back({example, parameters.values(row, column_of(examples, example))});
    }
    for (std::size_t i = 0; i + 1 < check.order.size(); ++i) {
      if (!(check.order[i].value < check.order[i + 1].value)) check.violated.push_back(i);
    }
    checks.push_back(std::move(check));
  }
  return checks;
}

std::string sentence_of(const ExpectationCheck& check) {
  std::string order;
  for (std::size_t i = 0; i < check.order.size(); ++i) {
    const bool violated =
        std::find(check.violated.begin(), check.violated.end(), i - 1) != check.violated.end();
    if (i > 0) order += violated ? " ≥ " : " < ";
    order += fmt::format("{} {:.3f}", check.order[i].example, check.order[i].value);
  }
  return fmt::format("{}: {}, {}", check.parameter, order,
                     check.holds() ? "as expected" : "not as expected");
}

}  // namespace mien::pipeline
