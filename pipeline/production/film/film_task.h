#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/task_graph.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// The inputs of a film.
struct FilmSubject {
  const Stimulus& film;              ///< id, look and output of the film
  std::vector<std::string> motions;  ///< ids of the stimuli and examples that the film shows
  KeyBuilder stage;                  ///< key of the staging's inputs other than these motions
  Equalize equalize;                 ///< properties equalized with the study's other films
  std::function<scenes::Shot(const Equalized&)> make_shot;
};

/// The stored frames of a film: those that its output requests, or temporary ones until the film is
/// encoded.
struct StoredSequence {
  std::string path;  ///< "frames/walk"
  Hash key;
};

/// Returns where a film's task stores its frames. `task_key` is the key of that task.
StoredSequence stored_sequence(const Task& film, const Hash& task_key);

/// Return the inputs of the film of a stimulus or of an overlay. All arguments must outlive the
/// result. Overlays are not equalized.
FilmSubject subject_of(const Stimulus& stimulus, const Manifest& manifest,
                       FinishedMotions& motions);
FilmSubject subject_of(const Overlay& overlay, const Manifest& manifest, FinishedMotions& motions,
                       const SharedDeterminants& shared);

/// The task "film:<id>": stages the motions, renders them and encodes the frames during rendering.
/// Its artifacts are the files that the output requests, a contact sheet, and a record of the film
/// and its checks. It reads the artifacts of its stimuli's tasks "motion:<id>" and of the
/// equalizing tasks. `motions` and what `subject` refers to must outlive it.
Task film_task(const FilmSubject& subject, const FilmSettings& settings,
               const SharedDeterminants& shared, FinishedMotions& motions);

}  // namespace mien::pipeline
