#include "pipeline/questionnaire/trial_subjects.h"

#include <algorithm>
#include <utility>

#include "pipeline/manifest/asked.h"
#include "pipeline/questionnaire/incomplete_blocks.h"
#include "pipeline/questionnaire/random_order.h"

namespace mien::pipeline {

namespace {

std::string level_of_all(const Manifest& manifest, const std::vector<std::string>& stimuli,
                         const std::string& factor) {
  std::vector<std::string> levels;
  for (const std::string& stimulus : stimuli)
    levels.push_back(level_of(manifest, stimulus, factor));
  std::ranges::sort(levels);
  return levels.front() == levels.back() ? levels.front() : levels.front() + "+" + levels.back();
}

}  // namespace

TrialSubjects trial_subjects(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  TrialSubjects subjects;
  if (asked.trials == TrialForm::pair) {
    for (const auto& [one, other] : asked_pairs(manifest)) subjects.stimuli.push_back({one, other});
  } else {
    for (const std::string& id : asked_stimuli(manifest)) subjects.stimuli.push_back({id});
  }
  subjects.likeness.factors = asked.apart;
  for (const std::vector<std::string>& stimuli : subjects.stimuli) {
    std::vector<std::string> levels;
    for (const std::string& factor : asked.apart)
      levels.push_back(level_of_all(manifest, stimuli, factor));
    subjects.likeness.levels.push_back(std::move(levels));
    const std::string& factor = asked.order.factor;
    const std::string block = factor.empty() ? "main" : level_of_all(manifest, stimuli, factor);
    subjects.blocks.push_back(block.empty() ? "main" : block);
  }
  return subjects;
}

std::size_t subjects_per_participant(const Manifest& manifest, const TrialSubjects& subjects) {
  const auto own = static_cast<std::size_t>(questionnaire_of(manifest).per_participant);
  return own == 0 ? subjects.size() : std::min(own, subjects.size());
}

std::vector<std::vector<std::size_t>> shares(const Manifest& manifest,
                                             const TrialSubjects& subjects, std::size_t count) {
  return deal_blocks(subjects.size(), subjects_per_participant(manifest, subjects), count,
                     seed_of(manifest.seed, "shares"));
}

}  // namespace mien::pipeline
