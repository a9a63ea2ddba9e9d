#include "pipeline/production/run/told_warnings.h"

#include <algorithm>

#include "motion/text/excerpt.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_names_told = 6;

}  // namespace

std::vector<std::string> told_warnings(
    const std::vector<std::pair<std::string, std::string>>& said) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const auto& [name, warning] : said) {
    auto group = std::ranges::find(groups, warning, [](const auto& one) { return one.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {warning, {}});
    if (std::ranges::find(group->second, name) == group->second.end())
      group->second.push_back(name);
  }
  std::vector<std::string> told;
  for (const auto& [warning, names] : groups)
    told.push_back(motion::first_of(names, most_names_told) + ": " + warning);
  return told;
}

}  // namespace mien::pipeline
