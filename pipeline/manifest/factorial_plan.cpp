#include "pipeline/manifest/factorial_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/questionnaire_content.h"

namespace mien::pipeline {

namespace {

bool is_rated(const std::vector<std::string>& rated, const Stimulus& stimulus) {
  return std::ranges::find(rated, stimulus.id) != rated.end();
}

/// "modified − acted", "sad − 0.5 happy − 0.5 angry"
std::string weighted_levels(const LevelWeights& weights) {
  std::string text;
  for (const auto& [level, weight] : weights) {
    if (weight == 0.0) continue;
    if (text.empty())
      text = weight < 0.0 ? "−" : "";
    else
      text += weight < 0.0 ? " − " : " + ";
    if (std::abs(weight) != 1.0) text += fmt::format("{:.4g} ", std::abs(weight));
    text += level;
  }
  return text;
}

/// "“modified against acted” (modified − acted; at action walk; on sad-happy)"
std::string contrast_text(const PlannedContrast& contrast) {
  std::string text = fmt::format("“{}” ({}", contrast.name, weights_text(contrast));
  for (const auto& [factor, level] : contrast.at) text += fmt::format("; at {} {}", factor, level);
  if (!contrast.scales.empty()) text += fmt::format("; on {}", fmt::join(contrast.scales, ", "));
  return text + ")";
}

/// "the factors actor and emotion within and gender between participants"
std::string factors_text(const FactorialPlan& plan) {
  std::string text = plan.factors.empty()
                         ? "all factors of the stimuli"
                         : fmt::format("the factor{} {}", plan.factors.size() == 1 ? "" : "s",
                                       fmt::join(plan.factors, ", "));
  text += " within participants";
  if (!plan.between.empty()) text += fmt::format(" and groups by {}", plan.between);
  return text;
}

}  // namespace

std::vector<std::string> design_factors(const Manifest& manifest) {
  const FactorialPlan& plan = questionnaire_of(manifest).analysis.factorial;
  if (!plan.factors.empty()) return plan.factors;
  const std::vector<std::string> rated = questionnaire_stimuli(manifest);
  std::vector<std::string> varied;
  for (const std::string& factor : studied_factors(manifest)) {
    std::set<std::string> levels;
    for (const Stimulus& stimulus : manifest.stimuli)
      if (is_rated(rated, stimulus)) levels.insert(level_of(stimulus, factor));
    levels.erase("");
    if (levels.size() > 1) varied.push_back(factor);
  }
  return varied;
}

FactorTable design_table(const Manifest& manifest) {
  FactorTable table{design_factors(manifest), {}};
  const std::vector<std::string> rated = questionnaire_stimuli(manifest);
  for (const Stimulus& stimulus : manifest.stimuli) {
    std::vector<std::string>& row = table.rows.emplace_back(table.factors.size());
    if (!is_rated(rated, stimulus)) continue;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = level_of(stimulus, table.factors[i]);
  }
  return table;
}

std::string weights_text(const PlannedContrast& contrast) {
  std::vector<std::string> parts;
  for (const auto& [factor, weights] : contrast.weights) parts.push_back(weighted_levels(weights));
  if (parts.size() == 1) return parts.front();
  return fmt::format("({})", fmt::join(parts, ") × ("));
}

AnalysedAnswers analysed_answers(const Manifest& manifest) {
  const TrialForm& form = *questionnaire_of(manifest).trials;
  return form.stimuli > 1 && !form.is_on_scale ? AnalysedAnswers::choices
                                               : AnalysedAnswers::ratings;
}

std::string factorial_plan_text(const FactorialPlan& plan, AnalysedAnswers answers) {
  if (plan.empty()) return "";
  const bool are_choices = answers == AnalysedAnswers::choices;
  std::string text;
  if (!are_choices)
    text = fmt::format(
        "Analysis of variance of each scale by {}; p values with Greenhouse and Geisser's "
        "correction. "
        "The mixed models have random intercepts of participants and, if cells have several "
        "stimuli, of stimuli{}.\n",
        factors_text(plan),
        plan.random_slopes ? ", and random slopes of the factors for participants" : "");
  else if (!plan.factors.empty())
    text = fmt::format("Worths of the combinations of the levels of {}, on each scale.\n",
                       fmt::join(plan.factors, " and "));
  if (plan.contrasts.empty()) return text;
  text += are_choices ? "Planned contrasts of log-worths, tested with resampled participants:\n"
                      : "Planned contrasts, tested by paired t tests of the participants' contrast "
                        "scores:\n";
  for (const PlannedContrast& contrast : plan.contrasts)
    text += "- " + contrast_text(contrast) + "\n";
  return text;
}

std::string factorial_sentence(const FactorialPlan& plan, AnalysedAnswers answers) {
  if (plan.empty()) return "";
  std::string text;
  if (answers == AnalysedAnswers::ratings)
    text = fmt::format(
        "Ratings on each scale were planned to be analysed by a repeated-measures analysis of "
        "variance "
        "with {}, with p values corrected by Greenhouse and Geisser's method",
        factors_text(plan));
  else
    text = fmt::format("Choices were planned to be analysed by the Bradley-Terry model of {}",
                       plan.factors.empty() ? "the stimuli"
                                            : fmt::format("the combinations of the levels of {}",
                                                          fmt::join(plan.factors, " and ")));
  if (answers == AnalysedAnswers::ratings && plan.random_slopes)
    text +=
        ", and by mixed models with random intercepts of participants and stimuli and random "
        "slopes "
        "of the factors for participants";
  if (plan.contrasts.empty()) return text;
  std::vector<std::string> names;
  for (const PlannedContrast& contrast : plan.contrasts) names.push_back(contrast_text(contrast));
  return text + fmt::format(", and by the planned contrast{} {}", names.size() == 1 ? "" : "s",
                            fmt::join(names, ", "));
}

}  // namespace mien::pipeline
