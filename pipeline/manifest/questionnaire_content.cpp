#include "pipeline/manifest/questionnaire_content.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

namespace {

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::ranges::find(names, name) != names.end();
}

bool has_levels(const Stimulus& stimulus, const StimulusChoice& choice) {
  return std::ranges::all_of(choice.levels, [&](const auto& wanted) {
    return is_among(level_of(stimulus, wanted.first), wanted.second);
  });
}

/// For each stimulus, its levels of these factors.
std::vector<std::vector<std::string>> levels_by_id(const Manifest& manifest,
                                                   const std::vector<std::string>& ids,
                                                   const std::vector<std::string>& factors) {
  std::vector<std::vector<std::string>> levels;
  for (const std::string& id : ids) {
    std::vector<std::string>& own = levels.emplace_back();
    for (const std::string& factor : factors) own.push_back(level_of(manifest, id, factor));
  }
  return levels;
}

}  // namespace

const Questionnaire& questionnaire_of(const Manifest& manifest) {
  if (manifest.questionnaire) return *manifest.questionnaire;
  if (manifest.matching)
    throw Error(manifest.file.string() + " has a matching experiment but no questionnaire",
                "evaluate its trials with mien study evaluate");
  throw Error(manifest.file.string() + " has no questionnaire",
              "add questionnaire: {participants: …, scales: […]}, or matching: {participants: …}");
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
  if (!manifest.questionnaire && manifest.matching)
    return manifest.matching->title.text.empty() ? manifest.study : manifest.matching->title.text;
  const std::string& title = questionnaire_of(manifest).title.text;
  return title.empty() ? manifest.study : title;
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

ScaleSet questionnaire_scales(const Manifest& manifest) {
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

std::vector<std::string> questionnaire_stimuli(const Manifest& manifest) {
  const StimulusChoice& choice = questionnaire_of(manifest).stimuli;
  if (!choice.ids.empty()) return choice.ids;
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!stimulus.id.empty() && has_levels(stimulus, choice)) ids.push_back(stimulus.id);
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
  std::ranges::copy_if(asked.pairs, std::back_inserter(subjects),
                       [&](const auto& pair) { return pair.size() == asked.trials->stimuli; });
  if (!subjects.empty()) return subjects;
  const auto levels = levels_by_id(manifest, ids, asked.preference.alike);
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = i + 1; j < ids.size(); ++j)
      if (levels[i] == levels[j]) subjects.push_back({ids[i], ids[j]});
  return subjects;
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
