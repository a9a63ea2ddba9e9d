#include "pipeline/manifest/questionnaire_content.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "pipeline/manifest/adaptive_levels.h"
#include "pipeline/manifest/questionnaire_grid.h"
#include "pipeline/manifest/questionnaire_pairs.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

namespace {

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

bool is_chosen(const Stimulus& stimulus, const StimulusChoice& choice) {
  if (!choice.ids.empty()) return is_among(stimulus.id, choice.ids);
  return std::ranges::all_of(choice.levels, [&](const auto& wanted) {
    return is_among(level_of(stimulus, wanted.first), wanted.second);
  });
}

const Questionnaire& questionnaire_of(const Manifest& manifest) {
  if (manifest.questionnaire) return *manifest.questionnaire;
  if (manifest.matching)
    throw Error(manifest.file.string() + " has a matching experiment but no questionnaire",
                "evaluate its trials with mien study evaluate");
  if (manifest.adaptive)
    throw Error(manifest.file.string() + " has an adaptive experiment but no questionnaire",
                "analyse its steps with mien study chains");
  throw Error(manifest.file.string() + " has no questionnaire",
              "add questionnaire: {participants: …, scales: […]}, or matching: {participants: …}");
}

const Adaptive& adaptive_of(const Manifest& manifest) {
  if (manifest.adaptive) return *manifest.adaptive;
  if (manifest.questionnaire && !manifest.questionnaire->adaptive.factor.empty())
    throw Error(manifest.file.string() + " has adaptive trials but no adaptive experiment",
                "analyse its answers with mien study report");
  throw Error(manifest.file.string() + " has no adaptive experiment",
              "add adaptive: {participants: …, method: gibbs, words: […], space: {groups: all}}");
}

const Matching& matching_of(const Manifest& manifest) {
  if (manifest.matching) return *manifest.matching;
  throw Error(manifest.file.string() + " has no matching experiment",
              "add matching: {participants: …}");
}

std::vector<std::string> matching_targets(const Manifest& manifest) {
  const Matching& matching = matching_of(manifest);
  if (!matching.targets.empty()) return matching.targets;
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.role == Role::target && !is_among(stimulus.id, matching.practice))
      ids.push_back(stimulus.id);
  }
  return ids;
}

std::string title_of(const Manifest& manifest) {
  const LocalText& title = manifest.questionnaire ? manifest.questionnaire->title
                           : manifest.matching    ? manifest.matching->title
                           : manifest.adaptive    ? manifest.adaptive->title
                                                  : questionnaire_of(manifest).title;
  return title.text.empty() ? manifest.study : title.text;
}

ScaleSet scales_to_choose(const Manifest& manifest) {
  const ScaleChoice& choice = questionnaire_of(manifest).scales;
  if (!choice.file.empty()) return choice.own;
  ScaleSet scales = scales_of(manifest.scales);
  for (Scale& scale : emotion_scales().scales) {
    if (find_scale(scales, scale.id) == nullptr) scales.scales.push_back(std::move(scale));
  }
  return scales;
}

namespace {

ScaleSet chosen_scales(const Manifest& manifest) {
  const ScaleChoice& choice = questionnaire_of(manifest).scales;
  if (choice.emotions) return emotion_scales();
  if (choice.all) return choice.file.empty() ? scales_of(manifest.scales) : choice.own;
  const ScaleSet known = scales_to_choose(manifest);
  ScaleSet asked;
  asked.name = known.name;
  for (const std::string& id : choice.ids) {
    if (const Scale* scale = find_scale(known, id)) asked.scales.push_back(*scale);
  }
  return asked;
}

}  // namespace

ScaleSet questionnaire_scales(const Manifest& manifest) {
  ScaleSet scales = chosen_scales(manifest);
  if (!questionnaire_of(manifest).trials->is_on_slider) return scales;
  for (Scale& scale : scales.scales) {
    scale.least = 0.0;
    scale.most = 100.0;
  }
  return scales;
}

bool has_sliders(const Questionnaire& asked) {
  return asked.answer.slider || asked.trials->is_on_slider;
}

std::size_t scales_in_turn(const Manifest& manifest) {
  if (!questionnaire_of(manifest).trials->is_continuous) return 1;
  return std::max<std::size_t>(1, questionnaire_scales(manifest).scales.size());
}

std::vector<std::string> questionnaire_stimuli(const Manifest& manifest) {
  const StimulusChoice& choice = questionnaire_of(manifest).stimuli;
  if (!choice.ids.empty()) return choice.ids;
  if (const Questionnaire& asked = questionnaire_of(manifest); asked.trials->is_grid) {
    std::vector<std::string> listed;
    for (const std::vector<std::string>& set : asked.grid.sets)
      std::ranges::copy(set, std::back_inserter(listed));
    if (!listed.empty()) return listed;
  }
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!stimulus.id.empty() && is_chosen(stimulus, choice)) ids.push_back(stimulus.id);
  }
  return ids;
}

std::vector<std::vector<std::string>> questionnaire_subjects(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::vector<std::string> ids = questionnaire_stimuli(manifest);
  std::vector<std::vector<std::string>> subjects;
  if (asked.trials->stimuli == 1) {
    for (const std::string& id : ids) subjects.push_back({id});
    return subjects;
  }
  if (asked.trials->is_set) return subjects;
  if (asked.trials->is_grid) {
    for (const GridSet& set : grid_sets(manifest)) subjects.push_back(set.stimuli);
    return subjects;
  }
  subjects = different_pairs(manifest);
  if (asked.trials == &same_different_form) {
    const auto same = same_pairs(manifest, subjects);
    subjects.insert(subjects.end(), same.begin(), same.end());
  }
  return subjects;
}

std::size_t stimuli_per_trial(const Questionnaire& asked) {
  if (asked.trials->is_grid) return 0;
  return asked.trials->is_set ? static_cast<std::size_t>(asked.best_worst.size)
                              : asked.trials->stimuli;
}

std::size_t questionnaire_subject_count(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  if (!asked.trials->is_set) return questionnaire_subjects(manifest).size();
  return asked.best_worst.sets > 0 ? static_cast<std::size_t>(asked.best_worst.sets)
                                   : questionnaire_stimuli(manifest).size();
}

int analysed_trials(const Manifest& manifest) {
  if (const Questionnaire& asked = questionnaire_of(manifest); !asked.adaptive.empty())
    return adaptive_session_trials(asked);
  const int own = questionnaire_of(manifest).per_participant;
  const int all = static_cast<int>(questionnaire_subject_count(manifest));
  return own == 0 ? all : std::min(own, all);
}

int main_trials(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  return analysed_trials(manifest) + asked.repeated + asked.warm_up;
}

int attention_checks(const Manifest& manifest) {
  const int every = questionnaire_of(manifest).attention_every;
  if (every == 0) return 0;
  return (main_trials(manifest) - 1) / every * static_cast<int>(scales_in_turn(manifest));
}

std::vector<std::string> shown_stimuli(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  std::set<std::string> ids(asked.practice.begin(), asked.practice.end());
  ids.insert(asked.reference);
  for (const std::vector<std::string>& pair : asked.pairs) ids.insert(pair.begin(), pair.end());
  // All pairs of the stimuli show all of these.
  if (asked.pairs.empty())
    std::ranges::copy(questionnaire_stimuli(manifest), std::inserter(ids, ids.end()));
  std::vector<std::string> shown;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (ids.contains(stimulus.id)) shown.push_back(stimulus.id);
  }
  return shown;
}

PairPresentation pair_presentation(const Questionnaire& asked) {
  return asked.trials->is_in_turn ? PairPresentation::in_turn : asked.preference.shown;
}

std::vector<std::pair<std::string, std::string>> questionnaire_choices(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  std::vector<std::pair<std::string, std::string>> choices;
  for (const auto& [id, shown] : asked.choices) choices.emplace_back(id, shown.text);
  if (!choices.empty()) return choices;
  for (const std::string& id : questionnaire_stimuli(manifest)) {
    const std::string level = level_of(manifest, id, "emotion");
    const bool is_new =
        std::ranges::none_of(choices, [&](const auto& choice) { return choice.first == level; });
    if (!level.empty() && is_new) choices.emplace_back(level, level);
  }
  return choices;
}

std::string level_of(const Manifest& manifest, const std::string& stimulus,
                     const std::string& factor) {
  const auto found = std::ranges::find(manifest.stimuli, stimulus, &Stimulus::id);
  return found == manifest.stimuli.end() ? "" : level_of(*found, factor);
}

}  // namespace mien::pipeline
