#include "pipeline/manifest/repetitions.h"

#include <map>
#include <variant>

#include "pipeline/manifest/determinants.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

constexpr char repetition_remedy[] =
    "change the motion or look of one of them; ignore this if the repetition is intended";

/// Whether its pictures depend on the stimulus's id.
bool is_random_per_id(const scenes::PointLightOptions& dots) {
  const bool is_random = dots.scrambled || dots.phase_scrambled || dots.lifetime > 0 ||
                         dots.noise > 0 || dots.mask > 0;
  return is_random && !dots.seed;
}

/// The stimulus without what does not affect its pictures.
Stimulus as_rendered(Stimulus stimulus) {
  const scenes::PointLightOptions* dots = scenes::dots_in(stimulus.look.figure);
  if (dots == nullptr || !is_random_per_id(*dots)) stimulus.id.clear();
  // Dots have the colour that they are given; bodies may have that of their role.
  if (dots != nullptr) stimulus.role = Role::created;
  return stimulus;
}

Hash appearance_key(const Stimulus& stimulus, FileKeys& files) {
  const Stimulus rendered = as_rendered(stimulus);
  KeyBuilder key;
  add_motion(key, rendered, files);
  add_film(key, rendered, files);
  add_presentation(key, rendered.output.presentation);
  add_sound(key, rendered, {}, files);
  return key.key();
}

}  // namespace

std::vector<Repetition> repetitions_in(const Manifest& manifest) {
  FileKeys files;
  std::map<Hash, std::string> first_ids;
  std::vector<Repetition> repetitions;
  for (const Stimulus& stimulus : manifest.stimuli) {
    const auto [first, is_new] = first_ids.emplace(appearance_key(stimulus, files), stimulus.id);
    if (!is_new) repetitions.push_back({stimulus.path, stimulus.id, first->second});
  }
  return repetitions;
}

std::string to_sentence(const Repetition& repetition) {
  return "looks identical to \"" + repetition.first + "\"; " + repetition_remedy;
}

std::vector<std::string> repetition_warnings(const Manifest& manifest) {
  std::vector<std::string> warnings;
  for (const Repetition& repetition : repetitions_in(manifest))
    warnings.push_back(repetition.id + ": " + to_sentence(repetition));
  return warnings;
}

Fault repetition_fault(const Repetition& repetition, const Places& places) {
  return {place_of(places, repetition.path), repetition.path,
          "\"" + repetition.id + "\" looks identical to \"" + repetition.first + "\"",
          repetition_remedy};
}

}  // namespace mien::pipeline
