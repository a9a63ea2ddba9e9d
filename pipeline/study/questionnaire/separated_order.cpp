#include "pipeline/study/questionnaire/separated_order.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {

namespace {

using Indices = std::vector<std::size_t>;
using OptionalIndex = std::optional<std::size_t>;

constexpr int max_attempts = 400;
constexpr long max_steps = 200'000;  // of the exhaustive search

using LevelCounts = std::vector<std::map<std::string, std::size_t>>;

LevelCounts counts_of(const FactorLevels& factor_levels, const Indices& elements) {
  LevelCounts counts(factor_levels.factors.size());
  for (std::size_t f = 0; f < counts.size(); ++f) {
    for (const std::size_t element : elements) {
      const std::string& level = factor_levels.levels[element][f];
      if (!level.empty()) ++counts[f][level];
    }
  }
  return counts;
}

/// A greedy random attempt. The remaining elements of a level may fill at most every second
/// remaining place, so a level that does has to come next.
class Attempt {
 public:
  Attempt(const FactorLevels& factor_levels, Indices shuffled, OptionalIndex before)
      : factor_levels_(factor_levels),
        left_(std::move(shuffled)),
        last_(before),
        counts_(counts_of(factor_levels, left_)) {}

  /// The order; nullopt at a dead end.
  std::optional<Indices> run() {
    Indices order;
    while (!left_.empty()) {
      const auto next =
          std::ranges::find_if(left_, [&](std::size_t element) { return fits(element); });
      if (next == left_.end()) return std::nullopt;
      last_ = *next;
      order.push_back(*next);
      for (std::size_t f = 0; f < counts_.size(); ++f) {
        const std::string& level = factor_levels_.levels[*next][f];
        if (!level.empty()) --counts_[f][level];
      }
      left_.erase(next);
    }
    return order;
  }

 private:
  bool fits(std::size_t element) const {
    if (last_ && factor_levels_.share_level(*last_, element)) return false;
    for (std::size_t f = 0; f < counts_.size(); ++f) {
      for (const auto& [level, count] : counts_[f]) {
        const bool is_due = 2 * count > left_.size();
        if (is_due && factor_levels_.levels[element][f] != level) return false;
      }
    }
    return true;
  }

  const FactorLevels& factor_levels_;
  Indices left_;
  OptionalIndex last_;
  LevelCounts counts_;
};

/// An exhaustive depth-first search in the given order, up to a number of steps.
class Search {
 public:
  Search(const FactorLevels& factor_levels, Indices elements, OptionalIndex before)
      : factor_levels_(factor_levels), order_(std::move(elements)), before_(before) {}

  std::optional<Indices> run() {
    if (order_.empty() || place(0)) return order_;
    return std::nullopt;
  }

 private:
  bool place(std::size_t at) {
    if (at == order_.size()) return true;
    for (std::size_t i = at; i < order_.size() && ++steps_ < max_steps; ++i) {
      const OptionalIndex last = at == 0 ? before_ : order_[at - 1];
      if (last && factor_levels_.share_level(*last, order_[i])) continue;
      std::swap(order_[at], order_[i]);
      if (place(at + 1)) return true;
      std::swap(order_[at], order_[i]);
    }
    return false;
  }

  const FactorLevels& factor_levels_;
  Indices order_;
  OptionalIndex before_;
  long steps_ = 0;
};

}  // namespace

bool FactorLevels::share_level(std::size_t a, std::size_t b) const {
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (!levels[a][f].empty() && levels[a][f] == levels[b][f]) return true;
  return false;
}

std::optional<Indices> separated_order(const FactorLevels& factor_levels, const Indices& elements,
                                       OptionalIndex before, std::uint64_t seed,
                                       std::string_view name) {
  Indices shuffled(elements.size());
  for (int i = 0; i < max_attempts; ++i) {
    const Indices order = random_order(elements.size(), seed, fmt::format("{}/{}", name, i));
    for (std::size_t k = 0; k < order.size(); ++k) shuffled[k] = elements[order[k]];
    if (auto found = Attempt(factor_levels, shuffled, before).run()) return found;
  }
  return Search(factor_levels, shuffled, before).run();
}

std::string no_order_reason(const FactorLevels& factor_levels, const Indices& elements) {
  const LevelCounts counts = counts_of(factor_levels, elements);
  for (std::size_t f = 0; f < counts.size(); ++f)
    for (const auto& [level, count] : counts[f])
      if (2 * count > elements.size() + 1)
        return fmt::format("{} of {} stimuli have {}: {}", count, elements.size(),
                           factor_levels.factors[f], level);
  return "none was found in any attempted order";
}

}  // namespace mien::pipeline
