#include "pipeline/study/results/factor_effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/statistics/exact_number.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/study/results/group_comparisons.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;

/// Participants' means of all cells on a scale; participants without a rating of some cell are
/// counted only.
struct CompleteCells {
  std::vector<std::size_t> people;
  Eigen::MatrixXd means;  ///< a row for each of them
  int incomplete = 0;
};

CompleteCells complete_cells(const AnswerSet& answer_set, const Crossing& crossing,
                             std::size_t scale) {
  std::map<std::size_t, std::size_t> cell_of;
  for (std::size_t cell = 0; cell < crossing.cells.size(); ++cell)
    for (const std::size_t stimulus : crossing.cells[cell]) cell_of[stimulus] = cell;
  std::map<std::size_t, std::vector<ExactSum>> sums;
  for (const AnalysedRating& rating : answer_set.ratings) {
    const auto cell = cell_of.find(rating.stimulus);
    if (rating.scale != scale || cell == cell_of.end()) continue;
    std::vector<ExactSum>& own = sums[rating.person];
    own.resize(crossing.cells.size());
    own[cell->second].add(ExactNumber::of(rating.value));
  }
  CompleteCells complete;
  std::erase_if(sums, [&](const auto& entry) {
    const bool is_incomplete =
        std::ranges::any_of(entry.second, [](const ExactSum& sum) { return sum.count == 0; });
    complete.incomplete += is_incomplete ? 1 : 0;
    return is_incomplete;
  });
  complete.means.resize(static_cast<Index>(sums.size()), static_cast<Index>(crossing.cells.size()));
  for (const auto& [person, own] : sums) {
    const auto row = static_cast<Index>(complete.people.size());
    for (std::size_t cell = 0; cell < own.size(); ++cell)
      complete.means(row, static_cast<Index>(cell)) = own[cell].mean().value();
    complete.people.push_back(person);
  }
  return complete;
}

/// Some rows of a matrix.
Eigen::MatrixXd rows_of(const Eigen::MatrixXd& all, const std::vector<Index>& rows) {
  return all(rows, Eigen::all);
}

void add_cells(const Eigen::MatrixXd& means, const std::string& group, ScaleEffects& result) {
  const bool has_margins = means.rows() > 1;
  Eigen::VectorXd margins =
      Eigen::VectorXd::Constant(means.cols(), std::numeric_limits<double>::quiet_NaN());
  if (has_margins) margins = within_participant_margins(means, 0.95);
  for (Index cell = 0; cell < means.cols(); ++cell) {
    const std::vector<double> values(means.col(cell).begin(), means.col(cell).end());
    const double mean = exact_mean(values);
    const double squares = (means.col(cell).array() - mean).square().sum();
    result.cells.push_back({group, static_cast<std::size_t>(cell), static_cast<int>(means.rows()),
                            mean, std::sqrt(squares / static_cast<double>(means.rows() - 1)),
                            margins[cell]});
  }
}

class EffectsOfFactors {
 public:
  EffectsOfFactors(const AnswerSet& answer_set, const ParticipantTable& participants,
                   FactorEffects& result)
      : answer_set_(answer_set), result_(result) {
    if (result.between.empty()) return;
    for (const auto& [answer, people] : people_by_answer(participants, result.between, answer_set))
      for (const std::size_t person : people) group_of_[person] = answer;
  }

  void add_scale(std::size_t scale) {
    ScaleEffects& own = result_.scales.emplace_back();
    own.scale = scale;
    CompleteCells complete = complete_cells(answer_set_, result_.crossing, scale);
    own.incomplete = complete.incomplete;
    std::vector<std::size_t> groups;
    if (!result_.between.empty()) keep_groups(complete, groups, own);
    own.people = static_cast<int>(complete.people.size());
    const bool has_too_few = result_.between.empty() ? own.people < 2 : own.groups.size() < 2;
    if (has_too_few) return;
    std::vector<int> levels;
    for (const auto& of_factor : result_.crossing.levels)
      levels.push_back(static_cast<int>(of_factor.size()));
    const std::vector<std::string> names = factor_names(answer_set_.factors, result_.crossing);
    for (const VarianceEffect& effect : analysis_of_variance(complete.means, levels, groups))
      own.effects.push_back(
          {effect_name({effect.factors, effect.by_group}, names, result_.between), effect});
    if (own.groups.empty()) return add_cells(complete.means, "", own);
    for (std::size_t group = 0; group < own.groups.size(); ++group) {
      std::vector<Index> rows;
      for (std::size_t i = 0; i < groups.size(); ++i)
        if (groups[i] == group) rows.push_back(static_cast<Index>(i));
      add_cells(rows_of(complete.means, rows), own.groups[group], own);
    }
  }

 private:
  /// Keeps the participants of groups with at least two members.
  void keep_groups(CompleteCells& complete, std::vector<std::size_t>& groups, ScaleEffects& own) {
    std::map<std::string, int> sizes;
    for (const std::size_t person : complete.people) {
      const auto group = group_of_.find(person);
      if (group != group_of_.end()) ++sizes[group->second];
    }
    for (const auto& [answer, size] : sizes)
      if (size >= 2) own.groups.push_back(answer);
    std::vector<Index> rows;
    std::vector<std::size_t> people;
    for (std::size_t i = 0; i < complete.people.size(); ++i) {
      const auto group = group_of_.find(complete.people[i]);
      const auto kept = group == group_of_.end() ? own.groups.end()
                                                 : std::ranges::find(own.groups, group->second);
      if (kept == own.groups.end()) {
        ++own.ungrouped;
        continue;
      }
      rows.push_back(static_cast<Index>(i));
      people.push_back(complete.people[i]);
      groups.push_back(static_cast<std::size_t>(kept - own.groups.begin()));
    }
    complete.means = rows_of(complete.means, rows);
    complete.people = people;
  }

  const AnswerSet& answer_set_;
  FactorEffects& result_;
  std::map<std::size_t, std::string> group_of_;
};

void correct_effects(FactorEffects& result, TestCorrection correction) {
  std::vector<double> p_values;
  for (const ScaleEffects& scale : result.scales)
    for (const FactorEffect& effect : scale.effects) p_values.push_back(effect.test.p_corrected);
  const std::vector<double> adjusted = corrected(p_values, correction);
  std::size_t next = 0;
  for (ScaleEffects& scale : result.scales)
    for (FactorEffect& effect : scale.effects) effect.adjusted = adjusted[next++];
}

std::string reason_of_none(const FactorTable& table) {
  if (table.factors.empty()) return "";
  if (table.factors.size() > most_factors)
    return fmt::format(
        "No analysis of variance: the stimuli differ in {} factors ({}). Name up to {} of them "
        "under "
        "questionnaire: analysis: factors.",
        table.factors.size(), fmt::join(table.factors, ", "), most_factors);
  if (!is_searchable(table))
    return "No analysis of variance: the design is incomplete and has too many levels to find the "
           "part that is complete. Name fewer factors under questionnaire: analysis: factors.";
  return "";
}

}  // namespace

FactorEffects factor_effects(const AnswerSet& answer_set, const ParticipantTable& participants) {
  FactorEffects result;
  const FactorTable& table = answer_set.factors;
  if (answer_set.ratings.empty()) return result;
  result.reason = reason_of_none(table);
  if (table.factors.empty() || !result.reason.empty()) return result;
  result.crossing = largest_crossing(table);
  if (result.crossing.empty()) {
    result.reason =
        "No analysis of variance: no factor has two levels at which the other factors have the "
        "same level. Name the factors to analyse under questionnaire: analysis: factors; ratings "
        "are averaged over the others.";
    return result;
  }
  result.between = answer_set.factorial.between;
  EffectsOfFactors effects(answer_set, participants, result);
  for (std::size_t scale = 0; scale < answer_set.scales.size(); ++scale) effects.add_scale(scale);
  correct_effects(result, answer_set.correction);
  return result;
}

std::vector<std::string> factor_names(const FactorTable& table, const Crossing& crossing) {
  std::vector<std::string> names;
  for (const std::size_t factor : crossing.factors) names.push_back(table.factors[factor]);
  return names;
}

std::string effect_name(const VarianceTerm& effect, const std::vector<std::string>& factors,
                        const std::string& between) {
  std::vector<std::string> names;
  if (effect.by_group) names.push_back(between);
  for (const std::size_t factor : effect.factors) names.push_back(factors[factor]);
  return fmt::format("{}", fmt::join(names, " × "));
}

std::string cell_name(const FactorTable& table, const Crossing& crossing, std::size_t cell) {
  std::vector<std::string> parts(crossing.factors.size());
  for (std::size_t i = crossing.factors.size(); i-- > 0;) {
    const std::vector<std::string>& levels = crossing.levels[i];
    parts[i] = table.factors[crossing.factors[i]] + " " + levels[cell % levels.size()];
    cell /= levels.size();
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::string> crossing_sentences(const AnswerSet& answer_set, const Crossing& crossing) {
  if (crossing.empty()) return {};
  const FactorTable& table = answer_set.factors;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < crossing.factors.size(); ++i)
    parts.push_back(fmt::format("{} ({})", table.factors[crossing.factors[i]],
                                fmt::join(crossing.levels[i], ", ")));
  std::vector<std::string> sentences = {
      fmt::format("Factors within participants: {}; {}.", fmt::join(parts, " × "),
                  counted_noun(crossing.cells.size(), "cell", "cells"))};
  if (!crossing.at.empty()) {
    std::vector<std::string> fixed;
    for (const auto& [factor, level] : crossing.at)
      fixed.push_back(table.factors[factor] + " " + level);
    sentences.push_back(
        fmt::format("Only at {}: these factors are not completely crossed with the others.",
                    fmt::join(fixed, ", ")));
  }
  std::set<std::size_t> used;
  for (const auto& cell : crossing.cells) used.insert(cell.begin(), cell.end());
  std::vector<std::string> unused;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool is_rated =
        std::ranges::any_of(table.rows[i], [](const std::string& level) { return !level.empty(); });
    if (is_rated && !used.contains(i)) unused.push_back(answer_set.stimuli[i].id);
  }
  if (!unused.empty())
    sentences.push_back(fmt::format(
        "Not in this analysis, because not all combinations of their levels were rated: {}.",
        fmt::join(unused, ", ")));
  return sentences;
}

}  // namespace mien::pipeline
