#include "pipeline/manifest/factor_crossing.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>

namespace mien::pipeline {

namespace {

using Levels = std::vector<std::vector<std::string>>;
using Combination = std::vector<std::size_t>;  // index of each factor's level

constexpr std::size_t most_searched = 16;

std::size_t position_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

/// The stimuli of each combination of levels; stimuli without a level of some factor are in none.
std::map<Combination, std::vector<std::size_t>> by_combination(const FactorTable& table,
                                                               const Levels& levels) {
  std::map<Combination, std::vector<std::size_t>> stimuli;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    Combination combination;
    for (std::size_t i = 0; i < levels.size(); ++i)
      combination.push_back(position_of(levels[i], table.rows[row][i]));
    const bool has_all = std::ranges::none_of(table.rows[row], &std::string::empty);
    if (has_all) stimuli[combination].push_back(row);
  }
  return stimuli;
}

/// Calls `visit` with each combination of the chosen levels, the last factor's varying fastest,
/// until it returns false. Returns whether it never did.
bool every_combination(const std::vector<Combination>& chosen, auto&& visit) {
  std::vector<std::size_t> at(chosen.size(), 0);
  Combination combination(chosen.size());
  for (;;) {
    for (std::size_t i = 0; i < chosen.size(); ++i) combination[i] = chosen[i][at[i]];
    if (!visit(combination)) return false;
    std::size_t i = chosen.size();
    while (i > 0 && ++at[i - 1] == chosen[i - 1].size()) at[--i] = 0;
    if (i == 0) return true;
  }
}

/// Number of factors with at least two levels, and number of cells.
std::pair<std::size_t, std::size_t> size_of(const std::vector<Combination>& chosen) {
  std::pair<std::size_t, std::size_t> size = {0, 1};
  for (const Combination& levels : chosen) {
    size.first += levels.size() > 1 ? 1 : 0;
    size.second *= levels.size();
  }
  return size;
}

std::size_t factor_with_most_levels(const Levels& levels) {
  return static_cast<std::size_t>(
      std::ranges::max_element(levels, {}, &std::vector<std::string>::size) - levels.begin());
}

/// Number of levels of all factors but the one with the most.
std::size_t searched_levels(const Levels& levels) {
  std::size_t count = 0;
  for (const auto& own : levels) count += own.size();
  return levels.empty() ? 0 : count - levels[factor_with_most_levels(levels)].size();
}

Levels all_levels(const FactorTable& table) {
  Levels levels;
  for (std::size_t i = 0; i < table.factors.size(); ++i) levels.push_back(table.levels_of(i));
  return levels;
}

/// Searches the levels to keep. For each choice of levels of all factors but the one with the most,
/// that factor keeps the levels that occur with all of these.
class CrossingSearch {
 public:
  CrossingSearch(const Levels& levels,
                 const std::map<Combination, std::vector<std::size_t>>& stimuli)
      : levels_(levels), stimuli_(stimuli), longest_(factor_with_most_levels(levels)) {}

  std::vector<Combination> largest() {
    std::vector<Combination> chosen(levels_.size());
    search(0, chosen);
    return best_;
  }

 private:
  void search(std::size_t factor, std::vector<Combination>& chosen) {
    if (factor == levels_.size()) return consider(chosen);
    if (factor == longest_) return search(factor + 1, chosen);
    const std::uint32_t all = (1U << levels_[factor].size()) - 1U;
    for (std::uint32_t kept = all; kept > 0; --kept) {
      chosen[factor].clear();
      for (std::size_t i = 0; i < levels_[factor].size(); ++i)
        // The first level is the highest bit, so that sets with levels that occur first come first.
        if ((kept >> (levels_[factor].size() - 1 - i) & 1U) != 0U) chosen[factor].push_back(i);
      search(factor + 1, chosen);
    }
  }

  void consider(std::vector<Combination>& chosen) {
    Combination kept;
    for (std::size_t level = 0; level < levels_[longest_].size(); ++level) {
      chosen[longest_] = {level};
      if (every_combination(chosen, [&](const Combination& c) { return stimuli_.contains(c); }))
        kept.push_back(level);
    }
    if (kept.empty()) return;
    chosen[longest_] = kept;
    if (best_.empty() || size_of(chosen) > size_of(best_)) best_ = chosen;
  }

  const Levels& levels_;
  const std::map<Combination, std::vector<std::size_t>>& stimuli_;
  std::size_t longest_;
  std::vector<Combination> best_;
};

std::vector<Combination> every_level(const Levels& levels) {
  std::vector<Combination> all;
  for (const auto& own : levels) {
    all.emplace_back(own.size());
    std::iota(all.back().begin(), all.back().end(), std::size_t{0});
  }
  return all;
}

std::vector<Combination> largest_choice(
    const Levels& levels, const std::map<Combination, std::vector<std::size_t>>& stimuli) {
  const std::vector<Combination> all = every_level(levels);
  if (every_combination(all, [&](const Combination& c) { return stimuli.contains(c); })) return all;
  if (searched_levels(levels) > most_searched) return {};
  return CrossingSearch(levels, stimuli).largest();
}

}  // namespace

std::vector<std::string> FactorTable::levels_of(std::size_t factor) const {
  std::vector<std::string> levels;
  for (const auto& row : rows)
    if (!row[factor].empty() && std::ranges::find(levels, row[factor]) == levels.end())
      levels.push_back(row[factor]);
  return levels;
}

std::size_t Crossing::stimuli() const {
  std::size_t count = 0;
  for (const auto& cell : cells) count += cell.size();
  return count;
}

bool is_searchable(const FactorTable& table) {
  return searched_levels(all_levels(table)) <= most_searched;
}

Crossing largest_crossing(const FactorTable& table) {
  const Levels levels = all_levels(table);
  if (levels.empty() || std::ranges::any_of(levels, &std::vector<std::string>::empty)) return {};
  const auto stimuli = by_combination(table, levels);
  const std::vector<Combination> chosen = largest_choice(levels, stimuli);
  Crossing crossing;
  if (chosen.empty()) return crossing;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i].size() == 1) {
      crossing.at.emplace_back(i, levels[i][chosen[i].front()]);
      continue;
    }
    crossing.factors.push_back(i);
    crossing.levels.emplace_back();
    for (const std::size_t level : chosen[i]) crossing.levels.back().push_back(levels[i][level]);
  }
  every_combination(chosen, [&](const Combination& c) {
    crossing.cells.push_back(stimuli.at(c));
    return true;
  });
  return crossing;
}

std::vector<MatchedSetting> matched_settings(
    const FactorTable& table, const std::vector<std::pair<std::string, LevelWeights>>& weights,
    const std::vector<std::pair<std::string, std::string>>& at) {
  const auto named = [&](const auto& list, std::size_t factor) {
    return std::ranges::find(list, table.factors[factor],
                             [](const auto& entry) { return entry.first; });
  };
  // By setting, then by the weighted levels: weight and stimuli.
  using Cells = std::map<std::vector<std::string>, std::pair<double, std::vector<std::size_t>>>;
  std::vector<std::pair<std::vector<std::string>, Cells>> settings;
  std::size_t wanted = 1;
  for (const auto& [factor, levels] : weights)
    wanted *= static_cast<std::size_t>(
        std::ranges::count_if(levels, [](const auto& level) { return level.second != 0.0; }));
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<std::string> setting, compared;
    double weight = 1.0;
    for (std::size_t i = 0; i < table.factors.size(); ++i) {
      const std::string& level = table.rows[row][i];
      if (level.empty()) weight = 0.0;
      const auto fixed = named(at, i);
      if (fixed != at.end() && fixed->second != level) weight = 0.0;
      const auto weighted = named(weights, i);
      if (weighted == weights.end()) {
        setting.push_back(level);
        continue;
      }
      compared.push_back(level);
      const auto own = std::ranges::find(weighted->second, level, &LevelWeights::value_type::first);
      weight *= own == weighted->second.end() ? 0.0 : own->second;
    }
    if (weight == 0.0) continue;
    auto found =
        std::ranges::find(settings, setting, [](const auto& entry) { return entry.first; });
    if (found == settings.end()) found = settings.insert(settings.end(), {setting, {}});
    auto& cell = found->second[compared];
    cell.first = weight;
    cell.second.push_back(row);
  }
  std::vector<MatchedSetting> matched;
  for (const auto& [setting, cells] : settings) {
    if (cells.size() != wanted) continue;
    MatchedSetting& own = matched.emplace_back();
    std::size_t next = 0;
    for (std::size_t i = 0; i < table.factors.size(); ++i)
      if (named(weights, i) == weights.end()) own.levels.emplace_back(i, setting[next++]);
    for (const auto& [levels, cell] : cells) own.cells.push_back(cell);
  }
  return matched;
}

}  // namespace mien::pipeline
