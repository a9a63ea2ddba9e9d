#include "pipeline/study/results/factor_contrasts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/statistics/exact_number.h"

namespace mien::pipeline {

namespace {

/// Weights as whole numbers over a common divisor, so that scores are exact.
struct WholeWeights {
  std::vector<std::int64_t> numerators;
  std::int64_t divisor = 1;
};

/// Nullopt if no divisor up to 1000 makes the weights whole.
std::optional<WholeWeights> whole_weights(const std::vector<double>& weights) {
  for (std::int64_t divisor = 1; divisor <= 1000; ++divisor) {
    WholeWeights whole{{}, divisor};
    for (const double weight : weights) {
      const double numerator = std::round(weight * static_cast<double>(divisor));
      if (std::abs(numerator - weight * static_cast<double>(divisor)) > 1e-9) break;
      whole.numerators.push_back(static_cast<std::int64_t>(numerator));
    }
    if (whole.numerators.size() == weights.size()) return whole;
  }
  return std::nullopt;
}

/// The cells of a contrast in all its settings.
struct ContrastCells {
  std::vector<double> weights;
  std::map<std::size_t, std::size_t> cell_of;  ///< by stimulus
  std::size_t settings = 0;

  explicit ContrastCells(const std::vector<MatchedSetting>& matched) : settings(matched.size()) {
    for (const MatchedSetting& setting : matched) {
      for (const auto& [weight, stimuli] : setting.cells) {
        for (const std::size_t stimulus : stimuli) cell_of[stimulus] = weights.size();
        weights.push_back(weight);
      }
    }
  }

  double score(const std::vector<ExactSum>& sums, const std::optional<WholeWeights>& whole) const {
    if (!whole) {
      double score = 0.0;
      for (std::size_t i = 0; i < weights.size(); ++i) score += weights[i] * sums[i].mean().value();
      return score / static_cast<double>(settings);
    }
    ExactNumber score;
    for (std::size_t i = 0; i < weights.size(); ++i) score += sums[i].mean() * whole->numerators[i];
    return (score / (whole->divisor * static_cast<std::int64_t>(settings))).value();
  }
};

/// Contrast scores of the participants who rated all cells.
std::vector<double> scores_on(const AnswerSet& answer_set, const ContrastCells& cells,
                              std::size_t scale, int& incomplete) {
  std::map<std::size_t, std::vector<ExactSum>> sums;
  for (const AnalysedRating& rating : answer_set.ratings) {
    const auto cell = cells.cell_of.find(rating.stimulus);
    if (rating.scale != scale || cell == cells.cell_of.end()) continue;
    std::vector<ExactSum>& own = sums[rating.person];
    own.resize(cells.weights.size());
    own[cell->second].add(ExactNumber::of(rating.value));
  }
  const std::optional<WholeWeights> whole = whole_weights(cells.weights);
  std::vector<double> scores;
  incomplete = 0;
  for (const auto& [person, own] : sums) {
    if (std::ranges::any_of(own, [](const ExactSum& sum) { return sum.count == 0; }))
      ++incomplete;
    else
      scores.push_back(cells.score(own, whole));
  }
  return scores;
}

/// Whether a contrast is on a scale.
bool is_asked_on(const PlannedContrast& contrast, const Scale& scale) {
  return contrast.scales.empty() ||
         std::ranges::find(contrast.scales, scale.id) != contrast.scales.end();
}

void add_contrast(const AnswerSet& answer_set, ContrastKind kind, const PlannedContrast& contrast,
                  std::vector<FactorContrast>& all) {
  const std::vector<MatchedSetting> matched =
      matched_settings(answer_set.factors, contrast.weights, contrast.at);
  if (matched.empty()) return;
  FactorContrast begun;
  begun.kind = kind;
  begun.weights = weights_text(contrast);
  begun.name = contrast.name.empty() ? begun.weights : contrast.name;
  for (const auto& [factor, weights] : contrast.weights)
    begun.factors += (begun.factors.empty() ? "" : " × ") + factor;
  for (const MatchedSetting& setting : matched)
    begun.settings.push_back(setting_name(answer_set.factors, setting));
  const ContrastCells cells(matched);
  for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) {
    if (!is_asked_on(contrast, answer_set.scales[scale])) continue;
    FactorContrast result = begun;
    result.scale = scale;
    result.within = within_participants(scores_on(answer_set, cells, scale, result.incomplete));
    if (result.within.people < 2 && kind == ContrastKind::pairwise) continue;
    result.dz_ends = cohens_dz_interval(result.within.t.t, result.within.people);
    all.push_back(std::move(result));
  }
}

void correct_contrasts(std::vector<FactorContrast>& all, TestCorrection correction,
                       auto&& is_member) {
  std::vector<FactorContrast*> members;
  std::vector<double> paired, ranks;
  for (FactorContrast& contrast : all) {
    if (!is_member(contrast)) continue;
    members.push_back(&contrast);
    paired.push_back(contrast.within.t.p);
    ranks.push_back(contrast.within.wilcoxon.p);
  }
  const std::vector<double> paired_after = corrected(paired, correction);
  const std::vector<double> ranks_after = corrected(ranks, correction);
  for (std::size_t i = 0; i < members.size(); ++i) {
    members[i]->paired_adjusted = paired_after[i];
    members[i]->wilcoxon_adjusted = ranks_after[i];
  }
}

}  // namespace

std::string setting_name(const FactorTable& table, const MatchedSetting& setting) {
  std::vector<std::string> parts;
  for (const auto& [factor, level] : setting.levels)
    parts.push_back(table.factors[factor] + " " + level);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<FactorContrast> factor_contrasts(const AnswerSet& answer_set) {
  std::vector<FactorContrast> all;
  if (answer_set.ratings.empty()) return all;
  for (const PlannedContrast& contrast : answer_set.factorial.contrasts)
    add_contrast(answer_set, ContrastKind::planned, contrast, all);
  const FactorTable& table = answer_set.factors;
  for (std::size_t factor = 0; factor < table.factors.size(); ++factor) {
    const std::vector<std::string> levels = table.levels_of(factor);
    for (std::size_t one = 0; one < levels.size(); ++one) {
      for (std::size_t other = one + 1; other < levels.size(); ++other) {
        PlannedContrast pair;
        pair.weights = {{table.factors[factor], {{levels[one], 1.0}, {levels[other], -1.0}}}};
        add_contrast(answer_set, ContrastKind::pairwise, pair, all);
      }
    }
  }
  correct_contrasts(all, answer_set.correction,
                    [](const FactorContrast& c) { return c.kind == ContrastKind::planned; });
  for (const std::string& factor : table.factors)
    correct_contrasts(all, answer_set.correction, [&](const FactorContrast& c) {
      return c.kind == ContrastKind::pairwise && c.factors == factor;
    });
  return all;
}

}  // namespace mien::pipeline
