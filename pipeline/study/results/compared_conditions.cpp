#include "pipeline/study/results/compared_conditions.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mien::pipeline {

ComparedConditions compared_conditions(const AnswerSet& answer_set) {
  ComparedConditions result{{}, {}, {answer_set.factors.factors, {}}};
  const bool are_pooled = !answer_set.factorial.factors.empty();
  std::map<std::vector<std::string>, std::size_t> known;
  for (std::size_t i = 0; i < answer_set.stimuli.size(); ++i) {
    // An answer set that was not made from a manifest may have no levels.
    const std::vector<std::string> levels =
        i < answer_set.factors.rows.size()
            ? answer_set.factors.rows[i]
            : std::vector<std::string>(answer_set.factors.factors.size());
    const bool has_all = are_pooled && std::ranges::find(levels, "") == levels.end();
    const auto [place, is_new] =
        has_all ? known.try_emplace(levels, result.names.size()) : std::pair(known.end(), true);
    result.of_stimulus.push_back(is_new ? result.names.size() : place->second);
    if (!is_new) continue;
    result.names.push_back(has_all ? fmt::format("{}", fmt::join(levels, ", "))
                                   : answer_set.stimuli[i].id);
    result.factors.rows.push_back(levels);
  }
  return result;
}

}  // namespace mien::pipeline
