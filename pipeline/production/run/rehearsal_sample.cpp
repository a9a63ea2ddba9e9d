#include "pipeline/production/run/rehearsal_sample.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "pipeline/production/methods/study_facts.h"

namespace mien::pipeline {

namespace {

std::string kind_of(const Stimulus& stimulus) {
  std::string kind(source_of(stimulus));
  const auto add = [&](const std::string& word) { kind += "|" + word; };
  add(method_of(stimulus));
  for (const NamedValues* values : {&stimulus.adjectives, &stimulus.features}) {
    for (const auto& [name, value] : *values) add(name);
  }
  for (const ModificationStep& step : stimulus.modify) add("modified " + step.emotion);
  add(std::to_string(stimulus.look.figure.index()));
  add(scene_name(stimulus.look));
  add(stimulus.look.camera.view);
  return kind;
}

using Indices = std::set<std::size_t>;

Indices sample_of(const std::vector<Stimulus>& stimuli, std::size_t most) {
  std::set<std::string> kinds;
  Indices chosen;
  for (std::size_t i = 0; i < stimuli.size() && chosen.size() < most; ++i) {
    if (kinds.insert(kind_of(stimuli[i])).second) chosen.insert(i);
  }
  for (std::size_t step = 0; step < most && chosen.size() < most; ++step)
    chosen.insert(step * stimuli.size() / most);
  return chosen;
}

std::set<std::string> ids_of(const std::vector<Stimulus>& stimuli) {
  std::set<std::string> ids;
  for (const Stimulus& stimulus : stimuli) ids.insert(stimulus.id);
  return ids;
}

}  // namespace

Manifest rehearsal_sample(const Manifest& manifest, std::size_t most) {
  if (manifest.stimuli.size() <= most) return manifest;
  const Indices chosen = sample_of(manifest.stimuli, most);
  std::set<std::string> on_first;
  if (!manifest.overlays.empty()) {
    for (const auto& [role, name] : motions_on(manifest.overlays.front())) on_first.insert(name);
  }
  Manifest sample = manifest;
  sample.stimuli.clear();
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i) {
    const Stimulus& stimulus = manifest.stimuli[i];
    if (chosen.contains(i) || on_first.contains(stimulus.id)) sample.stimuli.push_back(stimulus);
  }
  const std::set<std::string> all = ids_of(manifest.stimuli);
  const std::set<std::string> kept = ids_of(sample.stimuli);
  const auto is_cut = [&](const Overlay& overlay) {
    return std::ranges::any_of(motions_on(overlay), [&](const auto& one) {
      return all.contains(one.second) && !kept.contains(one.second);
    });
  };
  std::erase_if(sample.overlays, is_cut);
  return sample;
}

}  // namespace mien::pipeline
