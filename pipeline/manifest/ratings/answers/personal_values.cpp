#include "pipeline/manifest/ratings/answers/personal_values.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace mien::pipeline {

namespace {

/// The scales that a parameter is made of: itself, or the members of a group.
std::vector<std::string> members_of(const std::string& parameter, const ScaleSet& scales) {
  const auto group = std::ranges::find(scales.groups, parameter, &ScaleGroup::id);
  if (group != scales.groups.end()) return group->scales;
  return {parameter};
}

}  // namespace

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
