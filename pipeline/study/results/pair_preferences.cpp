#include "pipeline/study/results/pair_preferences.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "pipeline/base/statistics/proportion.h"
#include "pipeline/study/results/comparisons.h"

namespace mien::pipeline {

std::string pair_question(const AnswerSet& answer_set, const std::string& item) {
  const auto scale = std::ranges::find(answer_set.scales, item, &Scale::id);
  return scale == answer_set.scales.end() ? item : "more " + scale->high;
}

std::vector<PreferenceCount> preferences_of(const AnswerSet& answer_set) {
  if (!answer_set.sets.empty()) return {};
  std::map<std::tuple<std::string, std::size_t, std::size_t>, PreferenceCount> counts;
  for (const AnalysedPreference& preference : answer_set.preferences) {
    const std::size_t one = std::min(preference.chosen, preference.other);
    const std::size_t other = std::max(preference.chosen, preference.other);
    PreferenceCount& count = counts[{preference.item, one, other}];
    count.item = preference.item;
    count.one = one;
    count.other = other;
    if (preference.is_tie) {
      ++count.ties;
      continue;
    }
    ++count.trials;
    count.for_one += preference.chosen == one ? 1 : 0;
  }
  std::vector<PreferenceCount> all;
  std::vector<double> p_values;
  for (auto& [key, count] : counts) {
    if (count.trials == 0) continue;
    const ShareInterval interval = wilson(count.for_one, count.trials);
    count.low = interval.low;
    count.high = interval.high;
    count.p = binomial_test(count.for_one, count.trials, 0.5);
    p_values.push_back(count.p);
    all.push_back(count);
  }
  const std::vector<double> adjusted = corrected(p_values, answer_set.correction);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].adjusted = adjusted[i];
  return all;
}

}  // namespace mien::pipeline
