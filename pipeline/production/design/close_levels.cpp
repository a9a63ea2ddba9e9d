#include "pipeline/production/design/close_levels.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "pipeline/manifest/people.h"
#include "pipeline/production/design/design_warning.h"

namespace mien::pipeline {

namespace {

// Each distance takes about a millisecond.
constexpr std::size_t most_pairs = 200;        // of two levels
constexpr std::size_t most_distances = 5'000;  // for one factor
constexpr std::size_t most_levels = 100;       // of one factor

/// Distances below this, metres, are those of one motion to itself.
constexpr double same_motion_m = 1e-6;

/// Levels of the other factors.
std::vector<std::string> other_levels(const Stimulus& stimulus, const std::string& factor,
                                      const std::vector<std::string>& factors) {
  std::vector<std::string> levels;
  for (const std::string& other : factors)
    if (other != factor) levels.push_back(level_of(stimulus, other));
  return levels;
}

std::optional<double> distance_between(const Stimulus& a, const Stimulus& b, Motions& motions) {
  const auto of_a = motions_in(a);
  const auto of_b = motions_in(b);
  if (of_a.size() != of_b.size()) return std::nullopt;
  try {
    double sum = 0.0;  // over the people where there are several
    for (std::size_t i = 0; i < of_a.size(); ++i)
      sum += motions.distance(of_a[i]->id, of_b[i]->id).mean;
    return sum / static_cast<double>(of_a.size());
  } catch (const Error&) {
    return std::nullopt;  // not both are people
  }
}

class LevelComparison {
 public:
  LevelComparison(const Manifest& manifest, Motions& motions, const std::string& factor)
      : manifest_(manifest), motions_(motions), factor_(factor) {
    const std::vector<std::string> factors = studied_factors(manifest);
    for (const Stimulus& stimulus : manifest.stimuli) {
      const std::string level = level_of(stimulus, factor);
      if (level.empty()) continue;
      if (!stimuli_.contains(level)) levels_.push_back(level);
      stimuli_[level].push_back({&stimulus, other_levels(stimulus, factor, factors)});
    }
    const std::size_t pairs = levels_.size() * (levels_.size() - 1) / 2;
    if (pairs > 0) limit_ = std::clamp<std::size_t>(most_distances / pairs, 1, most_pairs);
  }

  FactorLevels close() {
    FactorLevels found{.factor = factor_};
    if (levels_.size() > most_levels) return found;
    bool any_differs = false;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      for (std::size_t k = i + 1; k < levels_.size(); ++k) {
        const CloseLevels compared = compare(levels_[i], levels_[k]);
        if (compared.pairs == 0) continue;
        ++found.compared;
        any_differs = any_differs || compared.greatest_m > same_motion_m;
        if (compared.greatest_m < manifest_.design.threshold_m) found.close.push_back(compared);
      }
    }
    if (!any_differs) found.close.clear();
    std::ranges::stable_sort(found.close, {}, &CloseLevels::greatest_m);
    return found;
  }

 private:
  /// A stimulus with its levels of the other factors.
  struct Placed {
    const Stimulus* stimulus;
    std::vector<std::string> other_levels;
  };

  CloseLevels compare(const std::string& first, const std::string& second) {
    CloseLevels found{first, second};
    std::size_t tried = 0;
    for (const Placed& a : stimuli_[first]) {
      for (const Placed& b : stimuli_[second]) {
        if (a.other_levels != b.other_levels) continue;
        if (++tried > limit_) return found;
        const auto distance = distance_between(*a.stimulus, *b.stimulus, motions_);
        if (!distance) continue;
        found.greatest_m = std::max(found.greatest_m, *distance);
        ++found.pairs;
        if (found.greatest_m >= manifest_.design.threshold_m) return found;
      }
    }
    return found;
  }

  const Manifest& manifest_;
  Motions& motions_;
  const std::string& factor_;
  std::vector<std::string> levels_;
  std::map<std::string, std::vector<Placed>> stimuli_;  // by level
  std::size_t limit_ = 1;                               // of pairs of two levels
};

struct CloseLevelsRow {
  const FactorLevels& factor;
  const CloseLevels& levels;
};

constexpr auto close_levels_columns = table_of<CloseLevelsRow>(
    "metrics/close_levels.csv", "pair of levels of a factor whose motions are alike",
    {{"factor", "", "factor of the design", [](auto& r) { return r.factor.factor; }},
     {"first", "", "one level", [](auto& r) { return r.levels.first; }},
     {"second", "", "the other level", [](auto& r) { return r.levels.second; }},
     {"pairs", "", "compared pairs of stimuli, which have the same levels of all other factors",
      [](auto& r) { return r.levels.pairs; }},
     {"greatest_d_m", "m",
      "largest distance D of these pairs, below design.threshold_m; D does not measure speed",
      [](auto& r) { return r.levels.greatest_m; }}});

/// `"low" and "high" (D = 0.036 m)`, of the closest pairs.
std::string closest(const FactorLevels& factor) {
  constexpr std::size_t most = 3;
  std::vector<std::string> texts;
  for (const CloseLevels& one : factor.close) {
    if (texts.size() == most) {
      texts.emplace_back("…");
      break;
    }
    texts.push_back(fmt::format("\"{}\" and \"{}\" (D = {:.3f} m{})", one.first, one.second,
                                one.greatest_m, one.pairs > 1 ? " at most" : ""));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

const TableForm close_levels_form = close_levels_columns.form();

std::vector<FactorLevels> close_levels(const Manifest& manifest, Motions& motions) {
  std::vector<FactorLevels> all;
  const std::vector<std::string>& alike = manifest.design.alike;
  for (const std::string& factor : studied_factors(manifest)) {
    if (std::ranges::find(alike, factor) != alike.end()) continue;
    FactorLevels found = LevelComparison(manifest, motions, factor).close();
    if (!found.close.empty()) all.push_back(std::move(found));
  }
  return all;
}

std::vector<DesignWarning> close_level_warnings(const Manifest& manifest,
                                                const std::vector<FactorLevels>& factors) {
  std::vector<DesignWarning> warnings;
  for (const FactorLevels& one : factors) {
    const std::string which =
        one.compared == 1 ? std::string("its levels")
                          : fmt::format("{} of {} pairs of levels", one.close.size(), one.compared);
    warnings.push_back(
        {path_of_factor(manifest, one.factor),
         fmt::format(
             "the motions of the factor \"{}\" may look alike: {} differ by less than {:g} m "
             "(speed aside): {}",
             one.factor, which, manifest.design.threshold_m, closest(one)),
         fmt::format(
             "use values farther apart or, if it is intended, state design: {{alike: [{}]}}",
             one.factor)});
  }
  return warnings;
}

std::string close_levels_csv(const std::vector<FactorLevels>& factors) {
  std::vector<CloseLevelsRow> rows;
  for (const FactorLevels& factor : factors)
    for (const CloseLevels& levels : factor.close) rows.push_back({factor, levels});
  return close_levels_columns.of(rows).csv;
}

}  // namespace mien::pipeline
