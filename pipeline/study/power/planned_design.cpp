#include "pipeline/study/power/planned_design.h"

#include <algorithm>
#include <utility>

#include "motion/error.h"
#include "pipeline/manifest/factorial_plan.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/trial_subjects.h"
#include "pipeline/study/results/factor_effects.h"

namespace mien::pipeline {

namespace {

/// Each participant's group: at any number of participants, group sizes are as near to the shares
/// as whole numbers allow.
std::vector<std::size_t> groups_by_shares(const std::vector<double>& shares,
                                          std::size_t participants) {
  double sum = 0.0;
  for (const double share : shares) sum += share;
  std::vector<double> sizes(shares.size(), 0.0);
  std::vector<std::size_t> groups;
  for (std::size_t person = 0; person < participants; ++person) {
    std::size_t next = 0;
    double most = -1.0;
    for (std::size_t group = 0; group < shares.size(); ++group) {
      const double lacking = shares[group] / sum * static_cast<double>(person + 1) - sizes[group];
      if (lacking <= most + 1e-9) continue;
      most = lacking;
      next = group;
    }
    sizes[next] += 1.0;
    groups.push_back(next);
  }
  return groups;
}

std::vector<DesignContrast> contrasts_of(const PlannedDesign& design, const FactorialPlan& plan) {
  std::vector<DesignContrast> contrasts;
  for (const PlannedContrast& planned : plan.contrasts) {
    const std::vector<MatchedSetting> matched =
        matched_settings(design.factors, planned.weights, planned.at);
    if (matched.empty()) continue;
    DesignContrast contrast{.name = planned.name};
    for (const MatchedSetting& setting : matched) {
      for (const auto& [weight, stimuli] : setting.cells) {
        contrast.weights.push_back(weight / static_cast<double>(matched.size()));
        contrast.cells.push_back(stimuli);
      }
    }
    for (const Scale& scale : design.scales)
      contrast.scales.push_back(planned.scales.empty() ||
                                std::ranges::find(planned.scales, scale.id) !=
                                    planned.scales.end());
    contrasts.push_back(std::move(contrast));
  }
  return contrasts;
}

void add_effects(PlannedDesign& design, const std::string& between) {
  if (design.factors.factors.empty() || design.factors.factors.size() > most_factors ||
      !is_searchable(design.factors))
    return;
  design.crossing = largest_crossing(design.factors);
  if (design.crossing.empty()) return;
  const std::vector<std::string> names = factor_names(design.factors, design.crossing);
  design.terms = variance_terms(design.crossing.factors.size(), !between.empty());
  for (const VarianceTerm& term : design.terms)
    design.effects.push_back(effect_name(term, names, between));
}

}  // namespace

std::vector<int> PlannedDesign::levels() const {
  std::vector<int> numbers;
  for (const auto& of_factor : crossing.levels)
    numbers.push_back(static_cast<int>(of_factor.size()));
  return numbers;
}

PlannedDesign planned_design(const Manifest& manifest, std::size_t participants,
                             const std::vector<double>& group_shares) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const bool rates = asked.trials->is_grid || asked.trials->stimuli == 1;
  if (!rates || asked.trials->is_detection || asked.answer.words ||
      questionnaire_scales(manifest).scales.empty())
    throw Error("this questionnaire has no ratings of stimuli",
                "leave the power of planned tests out");
  const FactorialPlan& plan = asked.analysis.factorial;
  PlannedDesign design;
  const TrialSubjects subjects = trial_subjects(manifest);
  const FactorTable all = design_table(manifest);
  design.factors.factors = all.factors;
  RatedStimuli rated = rated_stimuli(manifest, subjects, participants);
  design.stimuli = std::move(rated.ids);
  design.shares = std::move(rated.shares);
  for (const std::string& stimulus : design.stimuli) {
    const auto place = std::ranges::find(manifest.stimuli, stimulus, &Stimulus::id);
    design.factors.rows.push_back(
        all.rows[static_cast<std::size_t>(place - manifest.stimuli.begin())]);
  }
  design.scales = questionnaire_scales(manifest).scales;
  design.is_complete = subjects_per_participant(manifest, subjects) == subjects.size();
  if (!plan.between.empty()) {
    design.groups = groups_by_shares(
        group_shares.empty() ? std::vector<double>{0.5, 0.5} : group_shares, participants);
    design.group_count = group_shares.empty() ? 2 : group_shares.size();
  }
  add_effects(design, plan.between);
  design.contrasts = contrasts_of(design, plan);
  if (design.effects.empty() && design.contrasts.empty())
    throw Error("the study plans no tests of its factors",
                "state them under questionnaire: analysis: {factors: […], contrasts: […]}");
  return design;
}

}  // namespace mien::pipeline
