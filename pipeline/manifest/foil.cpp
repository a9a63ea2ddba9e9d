#include "pipeline/manifest/foil.h"

#include <algorithm>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

namespace {

bool has(const ModificationStep& step, FoilAspect aspect) {
  const motion::Modification& values = step.modification;
  const motion::RelativeChange& relative = values.relative;
  switch (aspect) {
    case FoilAspect::posture:
      return !values.posture.empty() || step.pose.has_value() || !relative.range.empty() ||
             relative.step_width != 1.0;
    case FoilAspect::path_length:
      return values.paths != 1.0 || values.gains.has_value() || motion::changes_swing(relative) ||
             values.gesture.height != 1.0 || values.gesture.width != 1.0;
    case FoilAspect::speed:
      return !motion::is_unit(values.tempo) || values.gesture.speed != 1.0;
    case FoilAspect::acceleration:
      break;
  }
  return values.acceleration != 0.0;
}

ModificationStep without(ModificationStep step, FoilAspect aspect) {
  motion::Modification& values = step.modification;
  switch (aspect) {
    case FoilAspect::posture:
      values.posture.clear();
      values.relative.range.clear();
      values.relative.step_width = 1.0;
      step.pose.reset();
      break;
    case FoilAspect::path_length:
      values.paths = 1.0;
      values.gains.reset();
      values.relative = motion::without_swing(values.relative);
      values.gesture.height = values.gesture.width = 1.0;
      break;
    case FoilAspect::speed:
      values.tempo = values.gesture.speed = 1.0;
      break;
    case FoilAspect::acceleration:
      values.acceleration = 0.0;
      break;
  }
  return step;
}

/// What the stimulus makes, with the modifications that are left.
void copy_motion_settings(const Stimulus& original, bool foil_says_on_fault, Stimulus& foil) {
  foil.adjectives = original.adjectives;
  foil.hold = original.hold;
  foil.features = original.features;
  foil.weights = original.weights;
  foil.clip = original.clip;
  foil.walk = original.walk;
  foil.interpolation = original.interpolation;
  if (!foil_says_on_fault) foil.on_fault = original.on_fault;
  foil.modify.clear();
  for (const ModificationStep& step : original.modify)
    foil.modify.push_back(without(step, foil.foil->differ));
}

std::vector<std::string> possible_originals(const Manifest& manifest) {
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!stimulus.foil && stimulus.people.empty()) ids.push_back(stimulus.id);
  }
  return ids;
}

void check_original(const Stimulus& original, const Stimulus& foil, FaultList& list) {
  const std::string path = member_path(foil.path, "foil");
  const std::string aspect(name_of(foil.foil->differ));
  for (const ModificationStep& step : original.modify) {
    if (!step.style) continue;
    list.add(path,
             motion::in_quotes(original.id) + " is modified by a method without separate aspects",
             "name a stimulus with an emotion or manual changes");
    return;
  }
  const auto has_aspect = [&](const ModificationStep& step) {
    return has(step, foil.foil->differ);
  };
  if (std::ranges::any_of(original.modify, has_aspect)) return;
  list.add(member_path(path, "differ"),
           "the modifications of " + motion::in_quotes(original.id) + " do not change its " +
               aspect + ", so the foil would be the same motion",
           "name another aspect, or a stimulus in which it is changed");
}

/// The stimulus that a foil is of; nullptr, with a fault in the list, where there is none.
const Stimulus* original_of(const Stimulus& foil, const Manifest& manifest, FaultList& list) {
  const std::string path = member_path(member_path(foil.path, "foil"), "of");
  const std::string& of = foil.foil->of;
  const auto named = std::ranges::find(manifest.stimuli, of, &Stimulus::id);
  if (named == manifest.stimuli.end()) {
    list.add(path, motion::in_quotes(of) + " is not a stimulus",
             motion::did_you_mean(of, possible_originals(manifest)));
    return nullptr;
  }
  if (!named->people.empty()) {
    list.add(path, motion::in_quotes(of) + " has several people, each with a motion",
             "name a stimulus with one motion");
    return nullptr;
  }
  if (!named->foil) return &*named;
  list.add(path, motion::in_quotes(of) + " is itself a foil",
           "name the stimulus of which it is a foil, " + motion::in_quotes(named->foil->of));
  return nullptr;
}

}  // namespace

std::vector<Fault> resolve_foils(Manifest& manifest) {
  FaultList list(manifest.places);
  for (Stimulus& foil : manifest.stimuli) {
    if (!foil.foil) continue;
    const std::string path = member_path(foil.path, "foil");
    for (const char* key : {"modify", "interpolation", "hold"}) {
      if (list.was_given(member_path(foil.path, key)))
        list.add(member_path(foil.path, key), "a foil inherits this from its stimulus",
                 "omit it, or set it in " + motion::in_quotes(foil.foil->of));
    }
    const Stimulus* original = original_of(foil, manifest, list);
    if (original == nullptr) continue;
    copy_motion_settings(*original, list.was_given(member_path(foil.path, "on_fault")), foil);
    check_original(*original, foil, list);
  }
  return list.take();
}

}  // namespace mien::pipeline
