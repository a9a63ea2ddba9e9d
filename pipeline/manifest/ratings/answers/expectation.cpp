#include "pipeline/manifest/ratings/answers/expectation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/statistics/t_test.h"

namespace mien::pipeline {

namespace {

constexpr double confidence = 0.95;

Eigen::Index column_of(const std::vector<RatedExample>& examples, const std::string& name) {
  return std::ranges::find(examples, name, &RatedExample::name) - examples.begin();
}

ExpectedStep step_between(const std::map<std::string, double>& lower,
                          const std::map<std::string, double>& higher) {
  std::vector<double> differences;
  for (const auto& [participant, value] : lower) {
    const auto other = higher.find(participant);
    if (other != higher.end()) differences.push_back(other->second - value);
  }
  const TTest test = paired_t_test(differences);
  return {static_cast<int>(differences.size()), test.mean, test.low(confidence),
          test.high(confidence)};
}

ExpectationCheck checked(const Expectation& expectation, const RatedExamples& examples) {
  ExpectationCheck check;
  check.parameter = expectation.parameter;
  const int row = examples.parameters.find(expectation.parameter);
  std::vector<std::map<std::string, double>> personal;
  for (const std::string& example : expectation.order) {
    const Eigen::Index column = column_of(examples.names, example);
    check.order.push_back({example, examples.parameters.values(row, column)});
    personal.push_back(personal_values(examples.answers, examples.scales,
                                       examples.names[static_cast<std::size_t>(column)],
                                       expectation.parameter));
  }
  for (std::size_t i = 0; i + 1 < check.order.size(); ++i) {
    if (!(check.order[i].value < check.order[i + 1].value)) check.violated.push_back(i);
    check.steps.push_back(step_between(personal[i], personal[i + 1]));
  }
  return check;
}

std::string text_of(const ExpectedStep& step) {
  if (step.people == 0) return "means only";
  std::string text = fmt::format("n = {}, {:+.2f}", step.people, step.difference);
  if (std::isnan(step.low)) return text;
  return text + fmt::format(", 95 % interval {:.2f} to {:.2f}", step.low, step.high);
}

const char* verdict_of(const ExpectationCheck& check) {
  if (!check.holds()) return "not as expected";
  const auto is_unknown = [](const ExpectedStep& step) { return std::isnan(step.low); };
  if (std::ranges::all_of(check.steps, is_unknown)) return "as expected (means only)";
  return check.is_certain() ? "as expected" : "in the expected direction, not significant";
}

/// The scales that a parameter is made of: itself, or the members of a group.
std::vector<std::string> members_of(const std::string& parameter, const ScaleSet& scales) {
  const auto group = std::ranges::find(scales.groups, parameter, &ScaleGroup::id);
  if (group != scales.groups.end()) return group->scales;
  return {parameter};
}

}  // namespace

bool ExpectationCheck::is_certain() const {
  return holds() && std::ranges::all_of(steps, &ExpectedStep::is_certain);
}

std::vector<ExpectationCheck> check_expectations(const std::vector<Expectation>& expected,
                                                 const RatedExamples& examples) {
  std::vector<ExpectationCheck> checks;
  for (const Expectation& expectation : expected) checks.push_back(checked(expectation, examples));
  return checks;
}

std::string sentence_of(const ExpectationCheck& check) {
  std::string order;
  for (std::size_t i = 0; i < check.order.size(); ++i) {
    const bool violated = std::ranges::find(check.violated, i - 1) != check.violated.end();
    if (i > 0) order += violated ? " ≥ " : " < ";
    order += fmt::format("{} {:.3f}", check.order[i].example, check.order[i].value);
    if (i > 0) order += " (" + text_of(check.steps[i - 1]) + ")";
  }
  return fmt::format("{}: {}: {}", check.parameter, order, verdict_of(check));
}

std::map<std::string, double> personal_values(const Answers& answers, const ScaleSet& scales,
                                              const RatedExample& example,
                                              const std::string& parameter) {
  const std::vector<std::string> members = members_of(parameter, scales);
  const auto known = scales_by_id(scales);
  std::map<std::string, std::pair<double, int>> sums;
  for (const Answer& answer : answers.answers) {
    const bool is_about = answer.stimulus == example.name ||
                          (!answer.stimulus.empty() && answer.stimulus == example.file_stem);
    if (!is_about || answer.participant.empty()) continue;
    if (std::ranges::find(members, answer.scale) == members.end()) continue;
    auto& [sum, count] = sums[answer.participant];
    sum += share_of(*known.at(answer.scale), answer.value);
    ++count;
  }
  std::map<std::string, double> values;
  for (const auto& [participant, tally] : sums)
    values.emplace(participant, tally.first / tally.second);
  return values;
}

}  // namespace mien::pipeline
