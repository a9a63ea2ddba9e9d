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

/// What a film is made of.
struct FilmSubject {
  const Stimulus& film;              ///< what it is called, its look and output
  std::vector<std::string> motions;  ///< stimuli and examples that are in it
  KeyBuilder stage;                  ///< what else decides how they are staged
  Equalize equalize;                 ///< what it has in common with the study's other films
  std::function<scenes::Shot(const Equalized&)> make_shot;
};

/// The stored frames of a film: those of its output, or temporary ones until it is encoded.
struct StoredSequence {
  std::string path;  ///< "frames/walk"
  Hash key;
};

/// The stored frames of a film's task, once the products of its inputs are known.
StoredSequence stored_sequence(const Task& film, const Hash& task_key);

/// Film of a stimulus, or of motions together. All that is passed outlives it. Overlays take no
/// part in what is equalized.
FilmSubject subject_of(const Stimulus& stimulus, const Manifest& manifest,
                       FinishedMotions& motions);
FilmSubject subject_of(const Overlay& overlay, const Manifest& manifest, FinishedMotions& motions,
                       const SharedDeterminants& shared);

/// The task "film:<id>": stages the motions, draws them and encodes the frames while they are
/// drawn. Its products are what the output asks for, a contact sheet, and a record of what was
/// drawn and checked. It reads the products of the tasks "motion:<id>" of its stimuli, and those of
/// the tasks that find what is equalized. What `subject` refers to outlives it.
Task film_task(const FilmSubject& subject, const FilmSettings& settings,
               const SharedDeterminants& shared, FinishedMotions& motions);

}  // namespace mien::pipeline
