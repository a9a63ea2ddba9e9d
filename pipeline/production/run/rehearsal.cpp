#include "pipeline/production/run/rehearsal.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/tasks/parallel.h"

namespace mien::pipeline {

namespace {

class Rehearsal : public FaultList {
 public:
  Rehearsal(const Manifest& manifest, Motions& motions)
      : FaultList(manifest.places), manifest_(manifest), motions_(motions) {}

  void play() {
    if (!goes("examples", [&] { motions_.repertoire(); })) return;
    const std::vector<Staging> stagings = staged();
    for (std::size_t i = 0; i < stagings.size(); ++i) tell(manifest_.stimuli[i], stagings[i]);
    if (!std::ranges::all_of(stagings, [](const Staging& one) { return one.wrong.empty(); }))
      return;
    for (const Overlay& overlay : manifest_.overlays) {
      goes(overlay.film.path, [&] {
        check_fades(overlay.film, shot_of(overlay, motions_, manifest_.seed).frame_count());
      });
    }
    if (manifest_.equalize.place) goes("equalize", [&] { check_places(manifest_, motions_); });
    if (!manifest_.equalize.luminance) return;
    goes("equalize", [&] {
      for (const Fault& fault : faults_in_light(manifest_, motions_))
        add(fault.path, fault.wrong, fault.remedy);
    });
  }

 private:
  /// What is wrong in a file has a place of its own; all else is told where the manifest asks for
  /// it.
  template <class Work>
  bool goes(const std::string& path, const Work& work) {
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
    if (staging.wrong.empty()) return check_fades(stimulus, staging.frames);
    add(stimulus.path, staging.wrong, "");
  }

  void check_fades(const Stimulus& film, int frames) {
    const std::string wrong = fade_fault(film, frames);
    if (wrong.empty()) return;
    const std::string own = member_path(film.path, "output.presentation");
    add(was_given(own) ? own : "output.presentation", wrong, fade_remedy);
  }

  const Manifest& manifest_;
  Motions& motions_;
};

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

}  // namespace mien::pipeline
