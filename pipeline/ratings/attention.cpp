#include "pipeline/ratings/attention.h"

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
  constexpr double rounding = 1e-9;
  for (Attention& own : all)
    own.is_excluded = own.passed < rule.least_passed * own.checks - rounding;
  return all;
}

std::string to_sentence(const AttentionRule& rule) {
  if (rule.least_passed <= 0.0) return "Nobody was left out for missing attention checks.";
  return fmt::format(
      "Participants who passed less than {:.3g} % of their attention checks were left out.",
      100.0 * rule.least_passed);
}

}  // namespace mien::pipeline
