#include "pipeline/study/questionnaire/apart.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "pipeline/study/questionnaire/orders.h"

namespace mien::pipeline {

namespace {

using Things = std::vector<std::size_t>;
using MaybeThing = std::optional<std::size_t>;

constexpr int most_attempts = 400;
constexpr long most_steps = 200'000;  // of the exhaustive search

using LevelCounts = std::vector<std::map<std::string, std::size_t>>;

LevelCounts counts_of(const Likeness& likeness, const Things& things) {
  LevelCounts counts(likeness.factors.size());
  for (std::size_t f = 0; f < counts.size(); ++f) {
    for (const std::size_t thing : things) {
      const std::string& level = likeness.levels[thing][f];
      if (!level.empty()) ++counts[f][level];
    }
  }
  return counts;
}

/// A greedy random attempt. The remaining things of a level may fill at most every second remaining
/// place, so a level that does has to come next.
class Attempt {
 public:
  Attempt(const Likeness& likeness, Things shuffled, MaybeThing before)
      : likeness_(likeness),
        left_(std::move(shuffled)),
        last_(before),
        counts_(counts_of(likeness, left_)) {}

  /// The order; nullopt at a dead end.
  std::optional<Things> run() {
    Things order;
    while (!left_.empty()) {
      const auto next = std::ranges::find_if(left_, [&](std::size_t thing) { return fits(thing); });
      if (next == left_.end()) return std::nullopt;
      last_ = *next;
      order.push_back(*next);
      for (std::size_t f = 0; f < counts_.size(); ++f) {
        const std::string& level = likeness_.levels[*next][f];
        if (!level.empty()) --counts_[f][level];
      }
      left_.erase(next);
    }
    return order;
  }

 private:
  bool fits(std::size_t thing) const {
    if (last_ && likeness_.are_alike(*last_, thing)) return false;
    for (std::size_t f = 0; f < counts_.size(); ++f) {
      for (const auto& [level, count] : counts_[f]) {
        const bool is_due = 2 * count > left_.size();
        if (is_due && likeness_.levels[thing][f] != level) return false;
      }
    }
    return true;
  }

  const Likeness& likeness_;
  Things left_;
  MaybeThing last_;
  LevelCounts counts_;
};

/// An exhaustive depth-first search in the given order, up to a number of steps.
class Search {
 public:
  Search(const Likeness& likeness, Things things, MaybeThing before)
      : likeness_(likeness), order_(std::move(things)), before_(before) {}

  std::optional<Things> run() {
    if (order_.empty() || place(0)) return order_;
    return std::nullopt;
  }

 private:
  bool place(std::size_t at) {
    if (at == order_.size()) return true;
    for (std::size_t i = at; i < order_.size() && ++steps_ < most_steps; ++i) {
      const MaybeThing last = at == 0 ? before_ : order_[at - 1];
      if (last && likeness_.are_alike(*last, order_[i])) continue;
      std::swap(order_[at], order_[i]);
      if (place(at + 1)) return true;
      std::swap(order_[at], order_[i]);
    }
    return false;
  }

  const Likeness& likeness_;
  Things order_;
  MaybeThing before_;
  long steps_ = 0;
};

}  // namespace

bool Likeness::are_alike(std::size_t a, std::size_t b) const {
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (!levels[a][f].empty() && levels[a][f] == levels[b][f]) return true;
  return false;
}

std::optional<Things> order_apart(const Likeness& likeness, const Things& things, MaybeThing before,
                                  std::uint64_t seed, std::string_view name) {
  Things shuffled(things.size());
  for (int i = 0; i < most_attempts; ++i) {
    const Things order = random_order(things.size(), seed, fmt::format("{}/{}", name, i));
    for (std::size_t k = 0; k < order.size(); ++k) shuffled[k] = things[order[k]];
    if (auto found = Attempt(likeness, shuffled, before).run()) return found;
  }
  return Search(likeness, shuffled, before).run();
}

std::string why_none(const Likeness& likeness, const Things& things) {
  const LevelCounts counts = counts_of(likeness, things);
  for (std::size_t f = 0; f < counts.size(); ++f)
    for (const auto& [level, count] : counts[f])
      if (2 * count > things.size() + 1)
        return fmt::format("{} of {} stimuli have {}: {}", count, things.size(),
                           likeness.factors[f], level);
  return "none was found in any attempted order";
}

}  // namespace mien::pipeline
