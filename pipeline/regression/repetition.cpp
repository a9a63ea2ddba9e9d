#include <algorithm>
#include <thread>

#include "pipeline/production/archive/scratch_folder.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/regression.h"
#include "pipeline/regression/rendition.h"

namespace mien::pipeline {

namespace {

struct MadeOnce {
  Hash motion;
  std::vector<render::Image8> frames;
};

MadeOnce made_of(const StimulusFacts& approved, Rendition& rendition, int threads,
                 const std::stop_token& stop) {
  const StagedFilm film = staged(approved.id, {&rendition, &rendition, &rendition}, threads);
  std::vector<int> frames;
  for (const KeyFrame& key : approved.key_frames)
    if (key.frame < film.shot.frame_count()) frames.push_back(key.frame);
  return {facts_of(approved.id, rendition).motion, drawn(film, frames, stop)};
}

void compare(const MadeOnce& first, const MadeOnce& again, Repetitions& result) {
  result.differing += int{first.motion != again.motion};
  for (std::size_t i = 0; i < first.frames.size(); ++i) {
    if (first.frames[i].channels == again.frames[i].channels) continue;
    ++result.differing;
    result.largest = std::max(result.largest,
                              render::picture_difference(first.frames[i], again.frames[i]).largest);
  }
}

/// One more each time; from one again where there are no more processors.
int threads_of(int time) {
  const auto processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return 1 + (time - 1) % processors;
}

}  // namespace

Repetitions repeated(const ComparedStudy& study, int times) {
  Repetitions result{.times = times};
  std::map<std::string, MadeOnce> first;
  for (int k = 1; times > 1 && k <= times; ++k) {
    const ScratchFolder scratch;
    Rendition rendition(study.now.manifest(), scratch.path(), k, study.stop);
    for (const StimulusFacts& approved : study.baseline.stimuli) {
      if (!study.compares(approved.id)) continue;
      if (find_stimulus(rendition.manifest(), approved.id) == nullptr) continue;
      MadeOnce made = made_of(approved, rendition, threads_of(k), study.stop);
      if (k == 1)
        first[approved.id] = std::move(made);
      else
        compare(first.at(approved.id), made, result);
    }
  }
  return result;
}

}  // namespace mien::pipeline
