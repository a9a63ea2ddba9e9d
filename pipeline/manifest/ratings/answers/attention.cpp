#include "pipeline/manifest/ratings/answers/attention.h"

#include <cstddef>
#include <map>

#include <fmt/format.h>

namespace mien::pipeline {

std::vector<Attention> attention_of(const std::vector<AnswerRow>& rows, const AttentionRule& rule) {
  std::vector<Attention> all;
  std::map<std::string, std::size_t> index;
  for (const AnswerRow& row : rows) {
    const auto [found, is_new] = index.emplace(row.participant, all.size());
    if (is_new) all.push_back({.participant = row.participant});
    if (!row.passed || row.is_practice) continue;
    Attention& own = all[found->second];
    ++own.checks;
    own.passed += *row.passed ? 1 : 0;
  }
  for (Attention& own : all) own.is_excluded = own.checks - own.passed > rule.most_failed;
  return all;
}

std::string to_sentence(const AttentionRule& rule) {
  if (rule.most_failed == 0)
    return "Participants who failed any attention check were excluded with all of their answers.";
  return fmt::format(
      "Participants who failed more than {} attention check{} were excluded with all of their "
      "answers.",
      rule.most_failed, rule.most_failed == 1 ? "" : "s");
}

}  // namespace mien::pipeline
