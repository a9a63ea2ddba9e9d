#include "pipeline/manifest/questionnaire_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/factors.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

using Pairs = std::vector<std::vector<std::string>>;

Pairs all_pairs(const std::vector<std::string>& ids) {
  Pairs pairs;
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = i + 1; j < ids.size(); ++j) pairs.push_back({ids[i], ids[j]});
  return pairs;
}

/// Keeps the pairs whose stimuli differ in the factor only.
void keep_differing_in(const Manifest& manifest, const std::string& factor, Pairs& pairs) {
  const std::vector<std::string> factors = studied_factors(manifest);
  std::erase_if(pairs, [&](const auto& pair) {
    const auto differs = [&](const std::string& one) {
      return level_of(manifest, pair[0], one) != level_of(manifest, pair[1], one);
    };
    return !differs(factor) || std::ranges::any_of(factors, [&](const std::string& one) {
      return one != factor && differs(one);
    });
  });
}

/// Keeps the pairs of which one stimulus has the signal.
void keep_with_one_signal(const Manifest& manifest, Pairs& pairs) {
  const std::vector<std::string> signal = signal_stimuli(manifest);
  const std::set<std::string> with(signal.begin(), signal.end());
  std::erase_if(pairs,
                [&](const auto& pair) { return with.contains(pair[0]) == with.contains(pair[1]); });
}

/// Keeps the pairs whose stimuli have the same levels of these factors.
void keep_alike(const Manifest& manifest, const std::vector<std::string>& factors, Pairs& pairs) {
  std::erase_if(pairs, [&](const auto& pair) {
    return std::ranges::any_of(factors, [&](const std::string& one) {
      return level_of(manifest, pair[0], one) != level_of(manifest, pair[1], one);
    });
  });
}

}  // namespace

std::vector<std::string> signal_stimuli(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::vector<std::string> rated = questionnaire_stimuli(manifest);
  std::set<std::string> candidates(rated.begin(), rated.end());
  if (!asked.pairs.empty()) candidates.clear();
  for (const auto& pair : asked.pairs) candidates.insert(pair.begin(), pair.end());
  candidates.insert(asked.practice.begin(), asked.practice.end());
  std::vector<std::string> ids;
  const bool is_named = !asked.signal.ids.empty() || !asked.signal.levels.empty();
  if (!is_named && asked.adaptive.empty()) return ids;
  const std::vector<std::string> above = is_named ? ids : stimuli_above_hardest_level(manifest);
  const auto has_signal = [&](const Stimulus& stimulus) {
    return is_named ? is_chosen(stimulus, asked.signal)
                    : std::ranges::find(above, stimulus.id) != above.end();
  };
  for (const Stimulus& stimulus : manifest.stimuli)
    if (candidates.contains(stimulus.id) && has_signal(stimulus)) ids.push_back(stimulus.id);
  return ids;
}

std::vector<std::vector<std::string>> different_pairs(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  Pairs pairs;
  std::ranges::copy_if(asked.pairs, std::back_inserter(pairs),
                       [&](const auto& pair) { return pair.size() == 2; });
  if (!pairs.empty()) return pairs;
  pairs = all_pairs(questionnaire_stimuli(manifest));
  if (asked.trials == &pair_form) keep_alike(manifest, asked.preference.alike, pairs);
  if (asked.trials == &two_interval_form) keep_with_one_signal(manifest, pairs);
  if (asked.trials == &same_different_form && !asked.same_different.differ_in.empty())
    keep_differing_in(manifest, asked.same_different.differ_in, pairs);
  return pairs;
}

std::vector<std::vector<std::string>> same_pairs(const Manifest& manifest, const Pairs& different) {
  Pairs pairs;
  if (different.empty()) return pairs;
  std::map<std::string, std::size_t> occurrences;
  for (const auto& pair : different)
    for (const std::string& id : pair) ++occurrences[id];
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli)
    if (occurrences.contains(stimulus.id)) ids.push_back(stimulus.id);
  if (ids.empty()) return pairs;
  const double same = questionnaire_of(manifest).same_different.same;
  const double wanted =
      std::max(1.0, std::round(same / (1.0 - same) * static_cast<double>(different.size())));
  // By largest remainders.
  std::vector<double> quotas;
  std::vector<std::size_t> counts;
  for (const std::string& id : ids) {
    quotas.push_back(wanted * static_cast<double>(occurrences[id]) /
                     (2.0 * static_cast<double>(different.size())));
    counts.push_back(static_cast<std::size_t>(quotas.back()));
  }
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) {
    return std::round(1e9 * (quotas[i] - static_cast<double>(counts[i])));
  });
  std::size_t left = static_cast<std::size_t>(wanted) -
                     std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  for (std::size_t i = 0; left > 0; i = (i + 1) % order.size(), --left) ++counts[order[i]];
  for (std::size_t i = 0; i < ids.size(); ++i)
    pairs.insert(pairs.end(), counts[i], {ids[i], ids[i]});
  return pairs;
}

}  // namespace mien::pipeline
