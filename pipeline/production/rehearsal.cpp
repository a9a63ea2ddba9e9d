#include "pipeline/production/rehearsal.h"

#include <string>

#include <fmt/format.h>

#include "pipeline/documents/fault_list.h"
#include "pipeline/film/film_exposure.h"
#include "pipeline/film/film_framing.h"
#include "pipeline/film/film_presentation.h"
#include "pipeline/film/film_shot.h"

namespace mien::pipeline {

namespace {

class Rehearsal : public FaultList {
 public:
  Rehearsal(const Manifest& manifest, Motions& motions)
      : FaultList(manifest.places), manifest_(manifest), motions_(motions) {}

  void play() {
    if (!goes("examples", [&] { motions_.repertoire(); })) return;
    bool all_go = true;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      const bool goes_well = goes(stimulus.path, [&] { stage(stimulus); });
      all_go = all_go && goes_well;
    }
    if (!all_go) return;
    for (const Overlay& overlay : manifest_.overlays) {
      goes(overlay.film.path, [&] {
        check_fades(overlay.film, shot_of(overlay, motions_, manifest_.seed).frame_count());
      });
    }
    if (manifest_.equalize.place) goes("equalize", [&] { check_places(manifest_, motions_); });
    if (manifest_.equalize.luminance) check_luminance();
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

  void stage(const Stimulus& stimulus) {
    check_fades(stimulus, shot_of(stimulus, motions_, manifest_.seed).frame_count());
  }

  void check_fades(const Stimulus& film, int frames) {
    const std::string wrong = fade_fault(film, frames);
    if (wrong.empty()) return;
    const std::string own = member_path(film.path, "output.presentation");
    add(was_given(own) ? own : "output.presentation", wrong, fade_remedy);
  }

  void check_luminance() {
    goes("equalize", [&] {
      for (const Fault& fault : faults_in_light(manifest_, motions_))
        add(fault.path, fault.wrong, fault.remedy);
    });
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
