#include "pipeline/production/design/confounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/production/design/design_warning.h"

namespace mien::pipeline {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Numbers that differ by less than this share of the larger one count as equal.
constexpr double equal_within = 0.01;

bool are_equal(double lowest, double highest) {
  return highest - lowest <= equal_within * std::max(std::abs(lowest), std::abs(highest));
}

/// Whether `design.varies` has that name for a factor.
bool is_intended(const Design& design, const std::string& factor, std::string_view what) {
  if (factor == what) return true;
  return std::ranges::any_of(design.varies, [&](const auto& one) {
    return one.first == factor && std::ranges::find(one.second, what) != one.second.end();
  });
}

LevelProperty level_of_texts(const std::vector<std::string>& texts) {
  LevelProperty level;
  std::set<std::string> seen;
  for (const std::string& text : texts)
    if (seen.insert(text).second) level.text += (level.text.empty() ? "" : "; ") + text;
  level.lowest = level.highest = level.mean = nan;
  return level;
}

LevelProperty level_of_numbers(const std::vector<double>& numbers) {
  LevelProperty level;
  level.lowest = *std::ranges::min_element(numbers);
  level.highest = *std::ranges::max_element(numbers);
  for (const double number : numbers) level.mean += number / static_cast<double>(numbers.size());
  return level;
}

/// η²: the sum of squares between levels as a share of the total.
double explained_share(const std::vector<std::vector<double>>& by_level) {
  double sum = 0.0, count = 0.0;
  for (const auto& level : by_level)
    for (const double number : level) sum += number, count += 1.0;
  const double mean = sum / count;
  double total = 0.0, between = 0.0;
  for (const auto& level : by_level) {
    double inside = 0.0;
    for (const double number : level) {
      inside += number / static_cast<double>(level.size());
      total += (number - mean) * (number - mean);
    }
    between += static_cast<double>(level.size()) * (inside - mean) * (inside - mean);
  }
  return total > 0.0 ? between / total : nan;
}

/// The stimuli with each level of a factor (indices), in the order of the manifest.
using StimuliByLevel = std::vector<std::pair<std::string, std::vector<std::size_t>>>;

StimuliByLevel stimuli_by_level(const Manifest& manifest, const std::string& factor) {
  StimuliByLevel levels;
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i) {
    const std::string level = level_of(manifest.stimuli[i], factor);
    if (level.empty()) continue;
    auto found = std::ranges::find(levels, level, &StimuliByLevel::value_type::first);
    if (found == levels.end()) found = levels.insert(found, {level, {}});
    found->second.push_back(i);
  }
  return levels;
}

PropertyRelation relation_of_texts(const std::vector<LevelProperty>& levels,
                                   const std::vector<std::size_t>& distinct) {
  if (!std::ranges::all_of(distinct, [](std::size_t count) { return count == 1; }))
    return PropertyRelation::varies;
  return std::ranges::all_of(levels,
                             [&](const auto& level) { return level.text == levels[0].text; })
             ? PropertyRelation::same
             : PropertyRelation::follows;
}

PropertyRelation relation_of_numbers(const std::vector<LevelProperty>& levels) {
  double lowest = levels[0].lowest, highest = levels[0].highest;
  for (const LevelProperty& level : levels) {
    lowest = std::min(lowest, level.lowest);
    highest = std::max(highest, level.highest);
  }
  if (are_equal(lowest, highest)) return PropertyRelation::same;
  const bool is_constant = std::ranges::all_of(
      levels, [](const auto& level) { return are_equal(level.lowest, level.highest); });
  const bool has_several =
      std::ranges::any_of(levels, [](const auto& level) { return level.stimuli > 1; });
  return is_constant && has_several ? PropertyRelation::follows : PropertyRelation::varies;
}

using TextsByLevel = std::vector<std::vector<std::string>>;

void set_texts(const TextsByLevel& texts, FactorProperty& found) {
  std::vector<std::size_t> distinct;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    found.levels[i].text = level_of_texts(texts[i]).text;
    distinct.push_back(std::set<std::string>(texts[i].begin(), texts[i].end()).size());
  }
  found.relation = relation_of_texts(found.levels, distinct);
}

/// Sounds that differ within levels may still be there at some levels only.
void set_sounds(TextsByLevel texts, FactorProperty& found) {
  set_texts(texts, found);
  if (found.relation != PropertyRelation::varies) return;
  for (std::vector<std::string>& of_level : texts)
    for (std::string& text : of_level)
      if (text != without_sound) text = "with";
  FactorProperty presence = found;
  set_texts(texts, presence);
  if (presence.relation == PropertyRelation::follows) found = presence;
}

/// None if the property is unknown for any of the stimuli.
std::optional<FactorProperty> relation_of(const std::string& factor, const StimuliByLevel& levels,
                                          std::size_t which,
                                          const std::vector<PropertyValues>& values) {
  FactorProperty found{.factor = factor, .property = &stimulus_properties[which], .explained = nan};
  std::vector<std::vector<double>> numbers;
  TextsByLevel texts;
  for (const auto& [level, stimuli] : levels) {
    std::vector<std::string>& own_texts = texts.emplace_back();
    std::vector<double>& of_level = numbers.emplace_back();
    for (const std::size_t i : stimuli) {
      own_texts.push_back(values[i][which].text);
      of_level.push_back(values[i][which].number);
    }
    if (found.property->is_number &&
        !std::ranges::all_of(of_level, [](double number) { return std::isfinite(number); }))
      return std::nullopt;
    LevelProperty& one = found.levels.emplace_back(
        found.property->is_number ? level_of_numbers(of_level) : level_of_texts(own_texts));
    one.level = level;
    one.stimuli = static_cast<int>(stimuli.size());
  }
  if (found.property->is_number) {
    found.explained = explained_share(numbers);
    found.relation = relation_of_numbers(found.levels);
  } else if (found.property->id == std::string_view("sound")) {
    set_sounds(texts, found);
  } else {
    set_texts(texts, found);
  }
  return found;
}

/// Whether each level of one factor occurs with one level of the other only, and the other way
/// round, and any level has several stimuli.
bool are_aliased(const StimuliByLevel& one, const Manifest& manifest, const std::string& other) {
  std::set<std::string> taken;
  bool has_several = false;
  for (const auto& [level, stimuli] : one) {
    std::set<std::string> with;
    for (const std::size_t i : stimuli) with.insert(level_of(manifest.stimuli[i], other));
    if (with.size() != 1 || with.begin()->empty() || !taken.insert(*with.begin()).second)
      return false;
    has_several = has_several || stimuli.size() > 1;
  }
  return has_several;
}

std::string shown(const LevelProperty& level, const StimulusProperty& property) {
  if (property.is_number)
    return fmt::format("{}: {:.3g} {}", level.level, level.mean, property.unit);
  constexpr std::size_t most = 40;
  return level.level + ": " + (level.text.size() > most ? "…" : level.text);
}

std::string shown(const FactorProperty& relation) {
  constexpr std::size_t most = 3;
  std::vector<std::string> texts;
  for (const LevelProperty& level : relation.levels) {
    if (texts.size() == most) {
      texts.emplace_back("…");
      break;
    }
    texts.push_back(shown(level, *relation.property));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

const char* relation_word(PropertyRelation relation) {
  switch (relation) {
    case PropertyRelation::same:
      return "same";
    case PropertyRelation::varies:
      return "varies";
    case PropertyRelation::follows:
      return "follows";
    case PropertyRelation::intended:
      return "intended";
  }
  return "";
}

struct ConfoundRow {
  const FactorProperty& relation;
  const LevelProperty& level;
};

constexpr auto confounds_columns = table_of<ConfoundRow>(
    "metrics/confounds.csv", "property of the stimuli with one level of a factor",
    {{"factor", "", "factor of the design", [](auto& r) { return r.relation.factor; }},
     {"level", "", "its level", [](auto& r) { return r.level.level; }},
     {"stimuli", "", "number of stimuli with that level", [](auto& r) { return r.level.stimuli; }},
     {"property", "", "property, as in design.varies",
      [](auto& r) { return r.relation.property->id; }},
     {"unit", "", "unit of the numbers; empty for texts",
      [](auto& r) { return r.relation.property->unit; }},
     {"texts", "", "the values of a text, each once, separated by \"; \"; empty for numbers",
      [](auto& r) { return r.level.text; }},
     {"lowest", "see unit", "lowest value of a number", [](auto& r) { return r.level.lowest; }},
     {"mean", "see unit", "mean of a number", [](auto& r) { return r.level.mean; }},
     {"highest", "see unit", "highest value of a number", [](auto& r) { return r.level.highest; }},
     {"eta_squared", "0–1",
      "share of the variance of a number that all levels of the factor explain; empty if it does "
      "not differ",
      [](auto& r) { return r.relation.explained; }},
     {"relation", "",
      "same: equal for all stimuli (numbers within 1 %); varies: differs within a level; follows: "
      "constant within levels and different between them (a confound); intended: the same, but "
      "stated by design.varies",
      [](auto& r) { return relation_word(r.relation.relation); }}});

}  // namespace

const TableForm confounds_form = confounds_columns.form();

std::vector<FactorProperty> factor_properties(const Manifest& manifest,
                                              const std::vector<PropertyValues>& values) {
  std::vector<FactorProperty> all;
  for (const std::string& factor : studied_factors(manifest)) {
    const StimuliByLevel levels = stimuli_by_level(manifest, factor);
    if (levels.size() < 2) continue;
    for (std::size_t which = 0; which < std::size(stimulus_properties); ++which) {
      std::optional<FactorProperty> relation = relation_of(factor, levels, which, values);
      if (!relation) continue;
      if (relation->relation == PropertyRelation::follows &&
          is_intended(manifest.design, factor, relation->property->id))
        relation->relation = PropertyRelation::intended;
      all.push_back(std::move(*relation));
    }
  }
  return all;
}

std::vector<DesignWarning> confound_warnings(const Manifest& manifest,
                                             const std::vector<FactorProperty>& relations) {
  std::vector<DesignWarning> warnings;
  for (const FactorProperty& relation : relations) {
    if (relation.relation != PropertyRelation::follows) continue;
    warnings.push_back(
        {path_of_factor(manifest, relation.factor),
         fmt::format(
             "the {} differs between the levels of the factor \"{}\" and is constant within "
             "them ({})",
             relation.property->name, relation.factor, shown(relation)),
         fmt::format(
             "make it the same for all levels or, if it is intended, state design: {{varies: "
             "{{{}: [{}]}}}}",
             relation.factor, relation.property->id)});
  }
  std::vector<std::string> factors = studied_factors(manifest);
  std::erase_if(factors, [&](const std::string& one) { return !is_stated(manifest, one); });
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const StimuliByLevel levels = stimuli_by_level(manifest, factors[i]);
    if (levels.size() < 2) continue;
    for (std::size_t k = i + 1; k < factors.size(); ++k) {
      if (!are_aliased(levels, manifest, factors[k]) ||
          is_intended(manifest.design, factors[i], factors[k]) ||
          is_intended(manifest.design, factors[k], factors[i]))
        continue;
      warnings.push_back(
          {path_of_factor(manifest, factors[k]),
           fmt::format(
               "the factors \"{}\" and \"{}\" cannot be told apart: each level of one occurs "
               "with one level of the other only",
               factors[i], factors[k]),
           fmt::format("cross them or, if it is intended, state design: {{varies: {{{}: [{}]}}}}",
                       factors[i], factors[k])});
    }
  }
  return warnings;
}

std::string confounds_csv(const std::vector<FactorProperty>& relations) {
  std::vector<ConfoundRow> rows;
  for (const FactorProperty& relation : relations)
    for (const LevelProperty& level : relation.levels) rows.push_back({relation, level});
  return confounds_columns.of(rows).csv;
}

}  // namespace mien::pipeline
