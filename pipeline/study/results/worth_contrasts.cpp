#include "pipeline/study/results/worth_contrasts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace mien::pipeline {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

WorthContrast begun(ContrastKind kind, std::size_t compared) {
  WorthContrast contrast{.kind = kind, .of = WorthWeights(compared, 0.0)};
  contrast.difference = contrast.error = contrast.statistic = no_number;
  contrast.degrees = contrast.p = no_number;
  contrast.ends = {no_number, no_number};
  return contrast;
}

/// The levels of the compared conditions alone.
FactorTable levels_of_compared(const ComparedConditions& conditions,
                               const std::vector<std::size_t>& compared) {
  FactorTable table{conditions.factors.factors, {}};
  for (const std::size_t condition : compared)
    table.rows.push_back(conditions.factors.rows[condition]);
  return table;
}

/// Each cell's weight is shared by its conditions, and each setting has the same weight.
WorthWeights weights_of(const std::vector<MatchedSetting>& matched, std::size_t compared) {
  WorthWeights weights(compared, 0.0);
  for (const MatchedSetting& setting : matched)
    for (const auto& [weight, members] : setting.cells)
      for (const std::size_t member : members)
        weights[member] +=
            weight / static_cast<double>(members.size()) / static_cast<double>(matched.size());
  return weights;
}

}  // namespace

std::vector<WorthContrast> begun_worth_contrasts(const AnswerSet& answer_set,
                                                 const ComparedConditions& conditions,
                                                 const std::vector<std::size_t>& compared,
                                                 const std::string& item) {
  std::vector<WorthContrast> all;
  const FactorTable table = levels_of_compared(conditions, compared);
  for (const PlannedContrast& planned : answer_set.factorial.contrasts) {
    if (!planned.scales.empty() && std::ranges::find(planned.scales, item) == planned.scales.end())
      continue;
    const std::vector<MatchedSetting> matched =
        matched_settings(table, planned.weights, planned.at);
    if (matched.empty()) continue;
    WorthContrast contrast = begun(ContrastKind::planned, compared.size());
    contrast.name = planned.name;
    contrast.weights = weights_text(planned);
    contrast.of = weights_of(matched, compared.size());
    for (const MatchedSetting& setting : matched)
      contrast.settings.push_back(setting_name(table, setting));
    all.push_back(std::move(contrast));
  }
  if (compared.size() > most_compared_in_pairs) return all;
  for (std::size_t one = 0; one < compared.size(); ++one) {
    for (std::size_t other = one + 1; other < compared.size(); ++other) {
      WorthContrast contrast = begun(ContrastKind::pairwise, compared.size());
      contrast.name = conditions.names[compared[one]] + " − " + conditions.names[compared[other]];
      contrast.weights = contrast.name;
      contrast.of[one] = 1.0;
      contrast.of[other] = -1.0;
      all.push_back(std::move(contrast));
    }
  }
  return all;
}

void set_by_answers(WorthContrast& contrast, double difference, double error) {
  const boost::math::normal standard;
  const double margin = quantile(standard, 0.975) * error;
  contrast.difference = difference;
  contrast.error = error;
  contrast.ends = {difference - margin, difference + margin};
  contrast.statistic = difference / error;
  contrast.degrees = no_number;
  contrast.p = std::isfinite(contrast.statistic)
                   ? 2.0 * cdf(complement(standard, std::abs(contrast.statistic)))
                   : no_number;
}

void set_by_participants(WorthContrast& contrast, double difference,
                         const ResampledContrast& resampled, int people) {
  contrast.difference = difference;
  contrast.error = resampled.error;
  contrast.ends = resampled.ends;
  contrast.statistic = difference / resampled.error;
  contrast.degrees = people - 1.0;
  contrast.p = std::isfinite(contrast.statistic)
                   ? 2.0 * cdf(complement(boost::math::students_t(contrast.degrees),
                                          std::abs(contrast.statistic)))
                   : no_number;
}

}  // namespace mien::pipeline
