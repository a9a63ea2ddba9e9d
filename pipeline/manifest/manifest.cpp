#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

Stimulus plain_stimulus(const Manifest& manifest) {
  Stimulus stimulus;
  stimulus.look = manifest.look;
  stimulus.output = manifest.output;
  stimulus.interpolation = manifest.interpolation;
  stimulus.interpolation.weights.nearest.seed = manifest.seed;
  stimulus.on_fault = manifest.on_fault;
  stimulus.regression = manifest.regression;
  return stimulus;
}

Overlay plain_overlay(const Manifest& manifest) {
  Overlay overlay;
  overlay.film.look = manifest.look;
  overlay.film.output = manifest.output;
  overlay.film.output.clips.clear();
  return overlay;
}

std::vector<std::pair<Role, std::string>> motions_on(const Overlay& overlay) {
  std::vector<std::pair<Role, std::string>> motions = {{Role::target, overlay.target},
                                                       {Role::created, overlay.created}};
  if (!overlay.reference.empty()) motions.emplace_back(Role::reference, overlay.reference);
  return motions;
}

std::vector<const Stimulus*> films_of(const Manifest& manifest) {
  std::vector<const Stimulus*> films;
  for (const Stimulus& stimulus : manifest.stimuli) films.push_back(&stimulus);
  for (const Overlay& overlay : manifest.overlays) films.push_back(&overlay.film);
  return films;
}

std::vector<std::string> motions_on(const Sheet& sheet) {
  if (!sheet.stills.empty()) return sheet.stills;
  if (!sheet.gallery.empty()) return sheet.gallery;
  std::vector<std::string> motions = {sheet.target, sheet.created};
  if (!sheet.reference.empty()) motions.push_back(sheet.reference);
  return motions;
}

std::vector<MotionPair> pairs_on(const Sheet& sheet) {
  if (!sheet.stills.empty()) return {};
  if (sheet.gallery.empty()) return {{sheet.target, sheet.created}};
  std::vector<MotionPair> pairs;
  for (std::size_t i = 1; i < sheet.gallery.size(); ++i) {
    pairs.push_back({sheet.gallery.front(), sheet.gallery[i]});
  }
  return pairs;
}

NameLanguage name_language(const Manifest& manifest) {
  if (manifest.names != NameLanguage::study) return manifest.names;
  std::string first;
  if (manifest.questionnaire) first = manifest.questionnaire->language.first();
  if (manifest.matching) first = manifest.matching->language.first();
  if (manifest.adaptive) first = manifest.adaptive->language.first();
  return first == "ja" ? NameLanguage::japanese : NameLanguage::english;
}

}  // namespace mien::pipeline
