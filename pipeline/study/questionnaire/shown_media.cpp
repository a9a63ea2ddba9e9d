#include "pipeline/study/questionnaire/shown_media.h"

#include <set>

#include "pipeline/manifest/asked.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

std::vector<std::string> shown_stimuli(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  std::set<std::string> ids(asked.practice.begin(), asked.practice.end());
  if (!asked.reference.empty()) ids.insert(asked.reference);
  if (asked.trials == TrialForm::pair) {
    for (const auto& [one, other] : asked_pairs(manifest)) ids.insert({one, other});
  } else {
    for (const std::string& id : asked_stimuli(manifest)) ids.insert(id);
  }
  std::vector<std::string> shown;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (ids.contains(stimulus.id)) shown.push_back(stimulus.id);
  }
  return shown;
}

std::vector<ShownMedia> shown_media(const Manifest& manifest) {
  std::vector<ShownMedia> media;
  const std::vector<std::string> shown = shown_stimuli(manifest);
  const std::set<std::string> ids(shown.begin(), shown.end());
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!ids.contains(stimulus.id)) continue;
    for (const render::VideoKind kind : stimulus.output.video) {
      const std::string name = render::with_ending(stimulus.id, kind).string();
      media.push_back({stimulus.id, "videos/" + name});
    }
    if (questionnaire_of(manifest).view == ShownAs::turn)
      media.push_back({stimulus.id, "clips/" + stimulus.id + ".glb"});
  }
  return media;
}

}  // namespace mien::pipeline
