#include "pipeline/production/run/rehearsal.h"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/film/film_sound.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/synthesis/motion_task.h"
#include "pipeline/tasks/parallel.h"

namespace mien::pipeline {

namespace {

class Rehearsal : public FaultList {
 public:
  Rehearsal(const Manifest& manifest, Motions& motions)
      : FaultList(manifest.places), manifest_(manifest), motions_(motions) {}

  void play() {
    if (!succeeds("examples", [&] { motions_.repertoire(); })) return;
    const std::vector<Staging> stagings = staged();
    for (std::size_t i = 0; i < stagings.size(); ++i) tell(manifest_.stimuli[i], stagings[i]);
    if (!std::ranges::all_of(stagings, [](const Staging& one) { return one.wrong.empty(); }))
      return;
    for (const Overlay& overlay : manifest_.overlays) {
      succeeds(overlay.film.path, [&] {
        check_fades(overlay.film, shot_of(overlay, motions_, manifest_.seed).frame_count());
      });
    }
    if (manifest_.equalize.place) succeeds("equalize", [&] { check_places(manifest_, motions_); });
    if (!manifest_.equalize.luminance) return;
    succeeds("equalize", [&] {
      for (const Fault& fault : faults_in_light(manifest_, motions_))
        add(fault.path, fault.wrong, fault.remedy);
    });
  }

 private:
  /// What is wrong in a file has a place of its own; all else is reported where the manifest asks
  /// for it.
  template <class Work>
  bool succeeds(const std::string& path, const Work& work) {
    try {
      work();
      return true;
    } catch (const Error& error) {
      add(path, error.what(), "");
      return false;
    }
  }

  /// What came of a stimulus.
  struct Staging {
    int frames = 0;
    std::string wrong;  ///< empty when it can be staged
  };

  Staging stage(const Stimulus& stimulus) const {
    try {
      return {shot_of(stimulus, motions_, manifest_.seed).frame_count(), ""};
    } catch (const Error& error) {
      return {0, error.what()};
    }
  }

  /// All stimuli, several at a time.
  std::vector<Staging> staged() const {
    std::vector<Staging> stagings(manifest_.stimuli.size());
    on_all_processors(stagings.size(),
                      [&](std::size_t i) { stagings[i] = stage(manifest_.stimuli[i]); });
    return stagings;
  }

  void tell(const Stimulus& stimulus, const Staging& staging) {
    if (!staging.wrong.empty()) return add(stimulus.path, staging.wrong, "");
    check_fades(stimulus, staging.frames);
    check_sound(stimulus, staging.frames);
    for (const Stimulus* motion : motions_in(stimulus)) {
      if (const std::string wrong = unwritable_clip(*motion, motions_); !wrong.empty())
        add_of_output(stimulus, "output.clips", wrong, "omit this format");
    }
  }

  void check_fades(const Stimulus& film, int frames) {
    const std::string wrong = fade_fault(film, frames);
    if (!wrong.empty()) add_of_output(film, "output.presentation", wrong, fade_remedy);
  }

  void check_sound(const Stimulus& stimulus, int frames) {
    if (!stimulus.sound || stimulus.output.video.empty()) return;
    try {
      film_sound(stimulus, manifest_.equalize.loudness, frames);
    } catch (const Error& error) {
      add(member_path(stimulus.path, "audio"), error.what(), "");
    }
  }

  /// A fault of what the film states itself or, if it does not, the manifest.
  void add_of_output(const Stimulus& film, const char* path, const std::string& wrong,
                     const std::string& remedy) {
    const std::string own = member_path(film.path, path);
    add(was_given(own) ? own : path, wrong, remedy);
  }

  const Manifest& manifest_;
  Motions& motions_;
};

std::string kind_of(const Stimulus& stimulus) {
  std::string kind(source_of(stimulus));
  for (const Person& person : stimulus.people) kind += "|" + kind_of(person.motion);
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
  for (const Stimulus& stimulus : stimuli) {
    for (const Stimulus* motion : motions_in(stimulus)) ids.insert(motion->id);
  }
  return ids;
}

}  // namespace

std::vector<Fault> rehearse(const Manifest& manifest) {
  Motions motions(manifest);
  return rehearse(manifest, motions);
}

std::vector<Fault> rehearse(const Manifest& manifest, Motions& motions) {
  Rehearsal rehearsal(manifest, motions);
  rehearsal.play();
  return in_reading_order(rehearsal.take());
}

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
    const auto is_on_first = [&](const Stimulus* motion) { return on_first.contains(motion->id); };
    if (chosen.contains(i) || std::ranges::any_of(motions_in(stimulus), is_on_first))
      sample.stimuli.push_back(stimulus);
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
