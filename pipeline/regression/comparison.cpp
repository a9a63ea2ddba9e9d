#include "pipeline/regression/comparison.h"

#include <algorithm>

namespace mien::pipeline {

std::string_view name_of(Cause cause) {
  for (const auto& [word, meaning] : cause_words)
    if (meaning == cause) return word;
  return "";
}

std::string_view name_of(Verdict verdict) {
  for (const auto& [word, meaning] : verdict_words)
    if (meaning == verdict) return word;
  return "";
}

std::vector<ValueChange> value_changes(const NamedValues& before, const NamedValues& now) {
  const auto value_in = [](const NamedValues& values, const std::string& name) {
    const auto found = std::ranges::find(values, name, &NamedValues::value_type::first);
    return found == values.end() ? 0.0 : found->second;
  };
  std::vector<ValueChange> changes;
  for (const auto& [name, value] : before)
    if (const double today = value_in(now, name); today != value)
      changes.push_back({name, value, today});
  for (const auto& [name, value] : now) {
    const bool is_new =
        std::ranges::find(before, name, &NamedValues::value_type::first) == before.end();
    if (is_new && value != 0.0) changes.push_back({name, 0.0, value});
  }
  return changes;
}

}  // namespace mien::pipeline
