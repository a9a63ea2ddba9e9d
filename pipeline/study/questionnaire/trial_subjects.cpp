#include "pipeline/study/questionnaire/trial_subjects.h"

#include <algorithm>
#include <map>
#include <utility>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/study/questionnaire/incomplete_blocks.h"
#include "pipeline/study/questionnaire/orders.h"

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

/// Kinds of subjects to be balanced between participants: levels of the factors of order and
/// `no_repeats`, and signal or noise.
std::vector<std::vector<std::size_t>> kinds_of(const TrialSubjects& subjects) {
  std::map<std::string, std::size_t> numbers;
  std::vector<std::vector<std::size_t>> kinds(subjects.size());
  const auto add = [&](std::size_t subject, std::size_t factor, const std::string& level) {
    if (level.empty()) return;
    const std::string name = std::to_string(factor) + "/" + level;
    kinds[subject].push_back(numbers.emplace(name, numbers.size()).first->second);
  };
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    add(i, 0, subjects.blocks[i]);
    const std::size_t factors = subjects.factor_levels.factors.size();
    for (std::size_t f = 0; f < factors; ++f) add(i, f + 1, subjects.factor_levels.levels[i][f]);
    if (!subjects.is_signal.empty())
      add(i, factors + 1, subjects.is_signal[i] ? "signal" : "noise");
  }
  return kinds;
}

/// Sets in which the stimuli occur equally often, and any two of them together about equally often.
std::vector<std::vector<std::string>> stimulus_sets(const Manifest& manifest) {
  const std::vector<std::string> ids = questionnaire_stimuli(manifest);
  std::vector<std::vector<std::string>> sets;
  for (const auto& block : incomplete_blocks(
           ids.size(), stimuli_per_trial(questionnaire_of(manifest)),
           questionnaire_subject_count(manifest), hashed_seed(manifest.seed, "sets"))) {
    sets.emplace_back();
    for (const std::size_t place : block) sets.back().push_back(ids[place]);
  }
  return sets;
}

}  // namespace

TrialSubjects trial_subjects(const Manifest& manifest) {
  const Questionnaire& questionnaire = questionnaire_of(manifest);
  TrialSubjects subjects{.stimuli = questionnaire.trials->is_set
                                        ? stimulus_sets(manifest)
                                        : questionnaire_subjects(manifest)};
  subjects.factor_levels.factors = questionnaire.no_repeats;
  for (const std::vector<std::string>& stimuli : subjects.stimuli) {
    std::vector<std::string> levels;
    for (const std::string& factor : questionnaire.no_repeats)
      levels.push_back(level_of_all(manifest, stimuli, factor));
    subjects.factor_levels.levels.push_back(std::move(levels));
    const std::string& factor = questionnaire.order.factor;
    const std::string block = factor.empty() ? "main" : level_of_all(manifest, stimuli, factor);
    subjects.blocks.push_back(block.empty() ? "main" : block);
  }
  if (questionnaire.trials == &yes_no_form || questionnaire.trials == &same_different_form) {
    const std::vector<std::string> signal = signal_stimuli(manifest);
    for (const std::vector<std::string>& stimuli : subjects.stimuli)
      subjects.is_signal.push_back(stimuli.size() > 1
                                       ? stimuli[0] != stimuli[1]
                                       : std::ranges::find(signal, stimuli[0]) != signal.end());
  }
  return subjects;
}

std::size_t subjects_per_participant(const Manifest& manifest, const TrialSubjects& subjects) {
  const auto own = static_cast<std::size_t>(questionnaire_of(manifest).per_participant);
  return own == 0 ? subjects.size() : std::min(own, subjects.size());
}

std::vector<std::vector<std::size_t>> participant_subjects(const Manifest& manifest,
                                                           const TrialSubjects& subjects,
                                                           std::size_t count) {
  return incomplete_blocks(subjects.size(), subjects_per_participant(manifest, subjects), count,
                           hashed_seed(manifest.seed, "shares"), kinds_of(subjects));
}

RatedStimuli rated_stimuli(const Manifest& manifest, const TrialSubjects& subjects,
                           std::size_t participants) {
  RatedStimuli rated;
  std::map<std::string, std::size_t> places;
  for (const std::vector<std::string>& stimuli : subjects.stimuli)
    for (const std::string& stimulus : stimuli)
      if (places.emplace(stimulus, rated.ids.size()).second) rated.ids.push_back(stimulus);
  for (const auto& own : participant_subjects(manifest, subjects, participants)) {
    std::vector<std::size_t>& share = rated.shares.emplace_back();
    for (const std::size_t subject : own)
      for (const std::string& stimulus : subjects.stimuli[subject])
        if (std::ranges::find(share, places.at(stimulus)) == share.end())
          share.push_back(places.at(stimulus));
  }
  return rated;
}

}  // namespace mien::pipeline
